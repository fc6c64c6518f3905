// CGAL's Surface_mesh: sound ones, and single corruptions through its public interface, beside its own checkers.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/version.h>

#include <twinedge/surface_mesh.hpp>

#include "trial.hpp"

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using V = Mesh::Vertex_index;
using H = Mesh::Halfedge_index;
using F = Mesh::Face_index;

// A grid of n × n squares.
static Mesh grid(unsigned n) {
  Mesh m;
  m.reserve((n + 1) * (n + 1), 2 * n * (n + 1), n * n);
  for (unsigned y = 0; y <= n; ++y)
    for (unsigned x = 0; x <= n; ++x) m.add_vertex(Point(x, y, 0));
  for (unsigned y = 0; y < n; ++y)
    for (unsigned x = 0; x < n; ++x) {
      const unsigned v = y * (n + 1) + x;
      m.add_face(V(v), V(v + 1), V(v + n + 2), V(v + n + 1));
    }
  return m;
}

static bool their_members(const Mesh &m) { return m.is_valid(false); }
static bool their_functions(const Mesh &m) { return CGAL::is_valid_polygon_mesh(m); }

// Every link set to every other value for which a rule is broken.
template <class Check>
static std::vector<trial::row> corrupt(const Mesh &sound, Check check) {
  std::vector<trial::row> rows;
  const auto change = [&](auto &&apply) {
    Mesh m = sound;
    apply(m);
    rows.back().judge(twinedge::of(m), [&] { return check(m); });
  };
  const unsigned vertices = sound.num_vertices(), half_edges = sound.num_halfedges(), faces = sound.num_faces();
  const H no_half_edge = Mesh::null_halfedge();
  rows.push_back({"`next` of a half-edge"});
  for (unsigned i = 0; i < half_edges; ++i)
    for (unsigned j = 0; j <= half_edges; ++j) {
      const H other = j < half_edges ? H(j) : no_half_edge;
      if (other != sound.next(H(i))) change([&](Mesh &m) { m.set_next_only(H(i), other); });
    }
  rows.push_back({"`prev` of a half-edge"});
  for (unsigned i = 0; i < half_edges; ++i)
    for (unsigned j = 0; j <= half_edges; ++j) {
      const H other = j < half_edges ? H(j) : no_half_edge;
      if (other != sound.prev(H(i))) change([&](Mesh &m) { m.set_prev_only(H(i), other); });
    }
  rows.push_back({"target of a half-edge"});
  for (unsigned i = 0; i < half_edges; ++i)
    for (unsigned j = 0; j <= vertices; ++j) {
      const V other = j < vertices ? V(j) : Mesh::null_vertex();
      if (other != sound.target(H(i))) change([&](Mesh &m) { m.set_target(H(i), other); });
    }
  rows.push_back({"face of a half-edge"});
  for (unsigned i = 0; i < half_edges; ++i)
    for (unsigned j = 0; j <= faces; ++j) {
      const F other = j < faces ? F(j) : Mesh::null_face();
      if (other != sound.face(H(i))) change([&](Mesh &m) { m.set_face(H(i), other); });
    }
  rows.push_back({"half-edge of a vertex, to one that arrives elsewhere"});
  for (unsigned i = 0; i < vertices; ++i)
    for (unsigned j = 0; j <= half_edges; ++j) {
      const H other = j < half_edges ? H(j) : no_half_edge;
      if (j == half_edges || sound.target(other) != V(i)) change([&](Mesh &m) { m.set_halfedge(V(i), other); });
    }
  rows.push_back({"half-edge of a face, to one of another face"});
  for (unsigned i = 0; i < faces; ++i)
    for (unsigned j = 0; j <= half_edges; ++j) {
      const H other = j < half_edges ? H(j) : no_half_edge;
      if (j == half_edges || sound.face(other) != F(i)) change([&](Mesh &m) { m.set_halfedge(F(i), other); });
    }
  return rows;
}

// Links that are easily read through a removed half-edge, and what a report names where the mesh stores a half-edge that arrives.
static void kept_half_edges() {
  const auto message = [](const Mesh &m, int position) -> std::string {
    const auto report = twinedge::of(m).validate();
    const auto *violation = twinedge_report_violation(report.get(), std::size_t(position));
    return violation ? twinedge_violation_message(violation) : "";
  };
  Mesh m;
  CGAL::make_icosahedron<Mesh, Point>(m);
  const auto a = m.add_vertex(), b = m.add_vertex();
  const auto edge = m.add_edge(a, b);
  m.set_halfedge(b, edge);
  m.remove_edge(m.edge(edge));
  trial::require(m.is_removed(m.halfedge(b)) && m.halfedge(b) == H(60), "vertex 13 keeps a removed half-edge");
  trial::require(message(m, 0).find("the leaving half-edge of vertex 13 is 60, which is no live record") == 0,
                 "a removed half-edge of a vertex breaks R1: " + message(m, 0));
  Mesh wrong;
  CGAL::make_icosahedron<Mesh, Point>(wrong);
  const H kept(7);
  const V other = wrong.target(kept) == V(2) ? V(3) : V(2);
  wrong.set_halfedge(other, kept);
  trial::require(message(wrong, 0).find("keeps half-edge 6, ") != std::string::npos, "the opposite is named: " + message(wrong, 0));
  // A half-edge without next: its vertex is not blamed for it.
  Mesh nil;
  CGAL::make_icosahedron<Mesh, Point>(nil);
  nil.set_next_only(nil.halfedge(V(0)), Mesh::null_halfedge());
  trial::require(twinedge::of(nil).validate().count(TWINEDGE_COUNT_VIOLATIONS) == 1, "one nil next is one violation");
}

int main() {
  std::printf("\nCGAL %s, `Surface_mesh`:\n", CGAL_VERSION_STR);
  // Removed elements are skipped.
  Mesh holed = grid(6);
  CGAL::Euler::remove_face(holed.halfedge(F(14)), holed);
  CGAL::Euler::remove_face(holed.halfedge(F(0)), holed);
  const auto report = twinedge::of(holed).validate();
  trial::require(holed.has_garbage() && report.valid() && report.count(TWINEDGE_COUNT_BORDERS) == 2, "a grid with a hole");
  trial::require(report.count(TWINEDGE_COUNT_VERTICES) == 48 && report.count(TWINEDGE_COUNT_FACES) == 34, "vacant slots");

  kept_half_edges();
  const Mesh small = grid(2);
  trial::table("`Surface_mesh`", "`m.is_valid()`", corrupt(small, their_members));
  trial::table("`Surface_mesh`", "`is_valid_polygon_mesh(m)`", corrupt(small, their_functions));
  // Last, as the corruptions fork this process.
  trial::healthy_header("`is_valid_polygon_mesh`");
  for (const unsigned n : {158, 500}) {
    const Mesh m = grid(n);
    trial::healthy("Surface_mesh", 4 * n * (n + 1), [&] { return twinedge::of(m); }, [&] { return their_functions(m); });
  }
  return 0;
}
