// twinedge::of(arrangement): a CGAL::Arrangement_2 of bounded curves, with its CCBs. O(n) on average.
#pragma once
#include "twinedge.hpp"
#include <CGAL/Arr_accessor.h>
#include <CGAL/Arrangement_2.h>
namespace twinedge {
template <class Traits, class Dcel> structure of(const CGAL::Arrangement_2<Traits, Dcel> &arrangement) {
  using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;
  const std::uint32_t nil = UINT32_MAX, dangling = nil - 1;
  const auto &d = CGAL::Arr_accessor<Arrangement>(const_cast<Arrangement &>(arrangement)).dcel();  // It is only read.
  std::unordered_map<const void *, std::uint32_t> numbers[4];  // Of vertices, half-edges, boundary components, faces.
  std::vector<std::uint32_t> columns[TWINEDGE_LINK_BOUNDARY_VERTEX + 1];
  const auto put = [&](twinedge_link link, std::uint32_t number) { columns[link].push_back(number); };
  const auto of = [&](int kind, const void *p) { return !p ? nil : numbers[kind].count(p) ? numbers[kind][p] : dangling; };
  const auto of_boundary = [&](auto *b, std::uint32_t half_edge, std::uint32_t vertex) {
    const auto [at, is_new] = numbers[TWINEDGE_RECORD_BOUNDARY].emplace(b, numbers[TWINEDGE_RECORD_BOUNDARY].size());
    if (is_new) put(TWINEDGE_LINK_BOUNDARY_HALF_EDGE, half_edge), put(TWINEDGE_LINK_BOUNDARY_VERTEX, vertex);
    if (is_new) put(TWINEDGE_LINK_BOUNDARY_FACE, of(TWINEDGE_RECORD_FACE, b->face()));
    return at->second;
  };
  const auto of_ccb = [&](auto *b) { return b ? of_boundary(b, of(TWINEDGE_RECORD_HALF_EDGE, b->halfedge()), nil) : nil; };
  const auto of_half_edge = [&](auto *h) { return h->is_on_inner_ccb() ? of_ccb(h->inner_ccb()) : of_ccb(h->outer_ccb()); };
  const auto of_vertex = [&](auto *v) { return v->is_isolated() ? of_boundary(v->isolated_vertex(), nil, of(0, v)) : nil; };
  for (auto v = d.vertices_begin(); v != d.vertices_end(); ++v) numbers[0].emplace(&*v, numbers[0].size());
  for (auto h = d.halfedges_begin(); h != d.halfedges_end(); ++h) numbers[1].emplace(&*h, numbers[1].size());
  for (auto f = d.faces_begin(); f != d.faces_end(); ++f) numbers[3].emplace(&*f, numbers[3].size());
  for (auto h = d.halfedges_begin(); h != d.halfedges_end(); ++h) {
    put(TWINEDGE_LINK_TARGET, of(0, h->vertex())), put(TWINEDGE_LINK_TWIN, of(1, h->opposite()));
    put(TWINEDGE_LINK_NEXT, of(1, h->next())), put(TWINEDGE_LINK_PREV, of(1, h->prev()));
    put(TWINEDGE_LINK_BOUNDARY, of_half_edge(&*h));
  }
  for (auto v = d.vertices_begin(); v != d.vertices_end(); ++v) {  // A vertex keeps a half-edge that arrives.
    const auto arriving = v->is_isolated() ? nil : of(1, v->halfedge());
    put(TWINEDGE_LINK_LEAVING, arriving < dangling ? columns[TWINEDGE_LINK_TWIN][arriving] : arriving);
    put(TWINEDGE_LINK_ISOLATED, of_vertex(&*v));
  }
  for (auto f = d.faces_begin(); f != d.faces_end(); ++f) {
    const auto outer = f->number_of_outer_ccbs();
    put(TWINEDGE_LINK_OUTER, outer > 1 ? dangling : outer ? of_half_edge(*f->outer_ccbs_begin()) : nil);
    put(TWINEDGE_LINK_INNER_FIRST, std::uint32_t(columns[TWINEDGE_LINK_INNER].size()));
    for (auto i = f->inner_ccbs_begin(); i != f->inner_ccbs_end(); ++i) put(TWINEDGE_LINK_INNER, of_half_edge(*i));
    for (auto i = f->isolated_vertices_begin(); i != f->isolated_vertices_end(); ++i) put(TWINEDGE_LINK_INNER, of_vertex(&*i));
  }
  put(TWINEDGE_LINK_INNER_FIRST, std::uint32_t(columns[TWINEDGE_LINK_INNER].size()));
  structure s;
  for (const int link : {1, 2, 3, 4, 6, 7, 8, 10, 11, 12, 13, 14, 15})  // Not ORIGIN, FACE, FACE_HALF_EDGE.
    s.column(static_cast<twinedge_link>(link), std::move(columns[link]));
  return std::move(s.preset("arrangement_2"));
}
}  // namespace twinedge
