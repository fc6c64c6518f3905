// CGAL's Arrangement_2: sound ones with holes and isolated vertices, and single corruptions of their records, beside its own checkers.
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#include <twinedge/arrangement_2.hpp>

#include "trial.hpp"

// Whole coordinates, and no crossings: doubles are exact here.
using Traits = CGAL::Arr_segment_traits_2<CGAL::Simple_cartesian<double>>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Point = Traits::Point_2;
using Segment = Traits::X_monotone_curve_2;
using Halfedge = Arrangement::Dcel::Halfedge;
using Vertex = Arrangement::Dcel::Vertex;
using Face = Arrangement::Dcel::Face;
using Outer = Arrangement::Dcel::Outer_ccb;
using Inner = Arrangement::Dcel::Inner_ccb;
using Isolated = Arrangement::Dcel::Isolated_vertex;

// n × n squares of side 10, and a triangle and an isolated vertex in every `every`th of them.
static void grid(Arrangement &arrangement, int n, int every) {
  std::vector<Segment> segments;
  std::vector<Point> points;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const Point at(10 * x, 10 * y);
      if (x < n) segments.emplace_back(at, Point(10 * x + 10, 10 * y));
      if (y < n) segments.emplace_back(at, Point(10 * x, 10 * y + 10));
      if (x == n || y == n || (y * n + x) % every) continue;
      const Point corners[] = {Point(10 * x + 2, 10 * y + 2), Point(10 * x + 8, 10 * y + 2), Point(10 * x + 2, 10 * y + 8)};
      for (int i = 0; i < 3; ++i) segments.emplace_back(corners[i], corners[(i + 1) % 3]);
      points.emplace_back(10 * x + 9, 10 * y + 9);
    }
  CGAL::insert_non_intersecting_curves(arrangement, segments.begin(), segments.end());
  for (const Point &point : points) CGAL::insert_point(arrangement, point);
}

// Its records, changeable.
struct records {
  std::vector<Halfedge *> half_edges;
  std::vector<Vertex *> vertices;
  std::vector<Face *> faces;
  std::vector<Outer *> outer;
  std::vector<Inner *> inner;
  std::vector<Isolated *> isolated;

  explicit records(Arrangement &arrangement) {
    for (auto h = arrangement.halfedges_begin(); h != arrangement.halfedges_end(); ++h) half_edges.push_back(&*h);
    for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v) vertices.push_back(&*v);
    for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f) faces.push_back(&*f);
    for (Face *f : faces) {
      for (auto i = f->outer_ccbs_begin(); i != f->outer_ccbs_end(); ++i) outer.push_back((*i)->outer_ccb());
      for (auto i = f->inner_ccbs_begin(); i != f->inner_ccbs_end(); ++i) inner.push_back((*i)->inner_ccb());
      for (auto i = f->isolated_vertices_begin(); i != f->isolated_vertices_end(); ++i) isolated.push_back(i->isolated_vertex());
    }
  }
};

// Every link set to every other record of its kind for which a rule is broken, each in a fresh arrangement.
template <class Check>
static std::vector<trial::row> corrupt(Check check) {
  std::vector<trial::row> rows;
  Arrangement arrangement;
  grid(arrangement, 2, 2);
  records all(arrangement);
  // `set` changes a link, and `undo` changes it back.
  const auto change = [&](auto &&set, auto &&undo) {
    set();
    rows.back().judge(twinedge::of(arrangement), [&] { return check(arrangement); });
    undo();
  };
  rows.push_back({"`next` of a half-edge, and `prev` of that"});
  for (Halfedge *h : all.half_edges)
    for (Halfedge *other : all.half_edges) {
      Halfedge *next = h->next(), *prev = other->prev();
      // The setters change both ends. Undone in this order, all links are as before.
      if (other != next) change([&] { h->set_next(other); }, [&] { prev->set_next(other), h->set_next(next); });
    }
  rows.push_back({"twin of a half-edge"});
  for (Halfedge *h : all.half_edges)
    for (Halfedge *other : all.half_edges) {
      Halfedge *twin = h->opposite();
      if (other != twin) change([&] { h->set_opposite(other); }, [&] { h->set_opposite(twin); });
    }
  rows.push_back({"target of a half-edge"});
  for (Halfedge *h : all.half_edges)
    for (Vertex *other : all.vertices) {
      Vertex *target = h->vertex();
      if (other != target) change([&] { h->set_vertex(other); }, [&] { h->set_vertex(target); });
    }
  rows.push_back({"boundary component of a half-edge"});
  for (Halfedge *h : all.half_edges) {
    const bool is_inner = h->is_on_inner_ccb();
    Outer *outer = is_inner ? nullptr : h->outer_ccb();
    Inner *inner = is_inner ? h->inner_ccb() : nullptr;
    const auto undo = [&] { is_inner ? h->set_inner_ccb(inner) : h->set_outer_ccb(outer); };
    for (Outer *other : all.outer)
      if (other != outer) change([&] { h->set_outer_ccb(other); }, undo);
    for (Inner *other : all.inner)
      if (other != inner) change([&] { h->set_inner_ccb(other); }, undo);
  }
  rows.push_back({"face of a boundary component"});
  for (Face *other : all.faces) {
    const auto faces = [&](auto &components) {
      for (auto *component : components) {
        Face *face = component->face();
        if (other != face) change([&] { component->set_face(other); }, [&] { component->set_face(face); });
      }
    };
    faces(all.outer), faces(all.inner), faces(all.isolated);
  }
  rows.push_back({"half-edge of a vertex, to one that arrives elsewhere"});
  for (Vertex *v : all.vertices)
    for (Halfedge *other : all.half_edges) {
      if (v->is_isolated() || other->vertex() == v) continue;
      Halfedge *kept = v->halfedge();
      change([&] { v->set_halfedge(other); }, [&] { v->set_halfedge(kept); });
    }
  trial::require(twinedge::of(arrangement).validate().valid() && arrangement.is_valid(), "every change was undone");
  return rows;
}

int main() {
  std::printf("\nCGAL %s, `Arrangement_2`:\n", CGAL_VERSION_STR);
  // Exact constructions: two squares that cross.
  using Exact = CGAL::Arr_segment_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;
  CGAL::Arrangement_2<Exact> crossing;
  for (const int at : {0, 1}) {
    const Exact::Point_2 corners[] = {{at, at}, {at + 2, at}, {at + 2, at + 2}, {at, at + 2}};
    for (int i = 0; i < 4; ++i) CGAL::insert(crossing, Exact::X_monotone_curve_2(corners[i], corners[(i + 1) % 4]));
  }
  const auto &constant = crossing;
  const auto report = twinedge::of(constant).validate();
  trial::require(report.valid() && report.count(TWINEDGE_COUNT_FACES) == 4, "two squares that cross");

  trial::table("`Arrangement_2`", "`arr.is_valid()`", corrupt([](Arrangement &a) { return a.is_valid(); }));
  trial::table("`Arrangement_2`", "`CGAL::is_valid(arr)`", corrupt([](Arrangement &a) { return CGAL::is_valid(a); }));
  // Last, as the corruptions fork this process.
  trial::healthy_header("`arr.is_valid()`");
  for (const int n : {135, 425}) {
    Arrangement arrangement;
    grid(arrangement, n, 3);
    trial::healthy("Arrangement_2", arrangement.number_of_halfedges(), [&] { return twinedge::of(arrangement); },
                   [&] { return arrangement.is_valid(); });
  }
  return 0;
}
