// Differences of CGAL 5.5.1 from its documentation. Each test fails when a later version mends it.
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/version.h>

#include <twinedge/arrangement_2.hpp>
#include <twinedge/surface_mesh.hpp>

#include "trial.hpp"

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using H = Mesh::Halfedge_index;

static Mesh tetrahedron() {
  Mesh m;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), m);
  return m;
}

// C1: the precondition of `join_loop` is that the faces are different and have as many edges as each other. Two neighbours keep it.
static void join_loop() {
  const Mesh sound = tetrahedron();
  int pairs = 0, right = 0, wrong = 0, hangs = 0;
  for (const H h : sound.halfedges_around_face(H(0)))
    for (const H g : sound.halfedges()) {
      if (sound.face(h) == sound.face(g)) continue;
      ++pairs;
      Mesh m = sound;
      const trial::answer answer = trial::in_child([&] {
        CGAL::Euler::join_loop(h, g, m);
        return twinedge::of(m).validate().valid();
      });
      right += answer == trial::accepts, hangs += answer == trial::hangs, wrong += answer == trial::refuses;
    }
  std::printf("C1 join_loop of two faces of a tetrahedron: of %d pairs %d do not return, %d break the mesh, %d are right\n", pairs, hangs,
              wrong, right);
  trial::require(hangs > 0 && wrong > 0, "C1 is still there");
}

// C2: `halfedge(v)` of a border vertex is a border half-edge, says the reference of `Surface_mesh`. `make_hole` does not set it.
static void make_hole() {
  int vertices = 0, inside = 0;
  for (unsigned i = 0; i < tetrahedron().num_halfedges(); ++i) {
    Mesh m = tetrahedron();
    CGAL::Euler::make_hole(H(i), m);
    trial::require(twinedge::of(m).validate().valid(), "the mesh is right but for that");
    const bool kept = twinedge::of(m).expect(TWINEDGE_EXPECTED_BORDER_KEPT).validate().valid();
    int here = 0;
    for (const auto v : m.vertices())
      if (m.is_border(v)) ++vertices, here += !m.is_border(v, false);
    trial::require(kept == (here == 0), "rule M8 says the same");
    inside += here;
  }
  std::printf("C2 make_hole in a tetrahedron: %d of %d border vertices keep a half-edge inside\n", inside, vertices);
  trial::require(inside > 0, "C2 is still there");
}

// C3: `CGAL::is_valid(arrangement)` accepts an arrangement of which `arrangement.is_valid()` is false.
static void is_valid() {
  using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Kernel>>;
  Arrangement arrangement;
  CGAL::insert(arrangement, Arrangement::X_monotone_curve_2(Kernel::Point_2(0, 0), Kernel::Point_2(1, 0)));
  Arrangement::Dcel::Halfedge &h = *arrangement.halfedges_begin();
  h.set_vertex(h.opposite()->vertex());
  const bool function = CGAL::is_valid(arrangement), member = arrangement.is_valid();
  std::printf("C3 a half-edge with the wrong target: CGAL::is_valid(arr) %d, arr.is_valid() %d\n", function, member);
  trial::require(!twinedge::of(arrangement).validate().valid(), "the arrangement is broken");
  trial::require(function && !member, "C3 is still there");
}

// C4: `Surface_mesh::is_valid` looks at no face of a half-edge.
static void labels() {
  Mesh m = tetrahedron();
  m.set_face(H(0), m.face(m.opposite(H(0))));
  const bool member = m.is_valid(false), function = CGAL::is_valid_polygon_mesh(m);
  std::printf("C4 a half-edge with the wrong face: m.is_valid() %d, is_valid_polygon_mesh(m) %d\n", member, function);
  trial::require(!twinedge::of(m).validate().valid(), "the mesh is broken");
  trial::require(member && !function, "C4 is still there");
}

int main() {
  std::printf("CGAL %s\n", CGAL_VERSION_STR);
  if (CGAL_VERSION_NR != CGAL_VERSION_NUMBER(5, 5, 1)) std::puts("the findings are of CGAL 5.5.1; this is another version");
  join_loop();
  make_hole();
  is_valid();
  labels();
  return 0;
}
