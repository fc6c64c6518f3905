// twinedge::of(mesh): a CGAL::Surface_mesh as columns. What is removed and not yet collected is a vacant slot. O(n).
//
// A Surface_mesh stores for each vertex a half-edge that arrives, `halfedge(v)`. Reports name one that leaves, which is derived: what
// follows `halfedge(v)`, if both are at v; else the opposite of `halfedge(v)`; `halfedge(v)` itself if that is nil or removed.
#pragma once
#include "twinedge.hpp"
#include <CGAL/Surface_mesh.h>

namespace twinedge {

template <class Point>
structure of(const CGAL::Surface_mesh<Point> &m) {
  using mesh = CGAL::Surface_mesh<Point>;
  const std::size_t vertices = m.num_vertices(), half_edges = m.num_halfedges(), faces = m.num_faces();
  std::vector<std::uint32_t> origin(half_edges), next(half_edges), prev(half_edges), face(half_edges);
  std::vector<std::uint32_t> leaving(vertices), kept(faces);
  std::vector<std::uint8_t> live_vertices(vertices), live_half_edges(half_edges), live_faces(faces);
  for (std::uint32_t i = 0; i < half_edges; ++i) {
    const typename mesh::Halfedge_index h(i);
    origin[i] = m.target(m.opposite(h));
    next[i] = m.next(h);
    prev[i] = m.prev(h);
    face[i] = m.face(h);
    live_half_edges[i] = !m.is_removed(h);
  }
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const typename mesh::Vertex_index v(i);
    const std::uint32_t arriving = m.halfedge(v);
    leaving[i] = arriving;  // Nil, past the end or vacant breaks R1. `next` of what is removed is CGAL's list of free slots.
    if (arriving < half_edges && live_half_edges[arriving]) {
      const std::uint32_t opposite = m.opposite(typename mesh::Halfedge_index(arriving)), follows = next[arriving];
      const bool arrives = origin[opposite] == i && follows < half_edges && origin[follows] == i;
      leaving[i] = arrives ? follows : opposite;
    }
    live_vertices[i] = !m.is_removed(v);
  }
  for (std::uint32_t i = 0; i < faces; ++i) {
    const typename mesh::Face_index f(i);
    kept[i] = m.halfedge(f);
    live_faces[i] = !m.is_removed(f);
  }
  structure s;
  s.column(TWINEDGE_LINK_ORIGIN, std::move(origin)).column(TWINEDGE_LINK_NEXT, std::move(next));
  s.column(TWINEDGE_LINK_PREV, std::move(prev)).column(TWINEDGE_LINK_FACE, std::move(face));
  s.column(TWINEDGE_LINK_LEAVING, std::move(leaving)).column(TWINEDGE_LINK_FACE_HALF_EDGE, std::move(kept));
  s.live(TWINEDGE_RECORD_VERTEX, std::move(live_vertices)).live(TWINEDGE_RECORD_FACE, std::move(live_faces));
  return std::move(s.live(TWINEDGE_RECORD_HALF_EDGE, std::move(live_half_edges)).preset("surface_mesh"));
}

}  // namespace twinedge
