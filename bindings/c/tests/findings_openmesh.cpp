// Differences of OpenMesh 9.0 from its documentation. Each test fails when a later version mends it.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/config.hh>
#include <OpenMesh/Tools/Utils/MeshCheckerT.hh>
#include <sstream>

#include <twinedge/openmesh.hpp>

#include "trial.hpp"

using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using V = OpenMesh::VertexHandle;
using H = OpenMesh::HalfedgeHandle;

static Mesh of_faces(int vertices, const std::vector<std::vector<V>> &faces) {
  Mesh m;
  m.request_vertex_status(), m.request_edge_status(), m.request_halfedge_status(), m.request_face_status();
  for (int v = 0; v < vertices; ++v) m.add_vertex(Mesh::Point(float(v), 0, 0));
  for (const auto &face : faces) m.add_face(face);
  return m;
}

static bool checker(const Mesh &m) {
  std::ostringstream ignored;
  return OpenMesh::Utils::MeshCheckerT<Mesh>(m).check(OpenMesh::Utils::MeshCheckerT<Mesh>::CHECK_ALL, ignored);
}

// A mesh with two edges between the vertices 1 and 2.
static Mesh with_parallel_edges(Mesh m) {
  m.insert_edge(H(0), H(4));
  trial::require(twinedge::of(m).validate().valid() && checker(m), "parallel edges are no fault of the mesh");
  return m;
}

// O1: a collapse "may lead to topological inconsistencies. Therefore you should check this using is_collapse_ok()".
static void collapse_leaves() {
  Mesh m = with_parallel_edges(of_faces(4, {{V(0), V(1), V(2), V(3)}}));
  const bool ok = m.is_collapse_ok(H(2));
  m.collapse(H(2));
  const H next = m.next_halfedge_handle(H(0));
  const bool deleted = m.status(m.edge_handle(next)).deleted();
  std::printf("O1 a square with a doubled side: is_collapse_ok %d; after collapse, next of half-edge 0 is %d, deleted: %d\n", ok, next.idx(),
              deleted);
  trial::require(!m.status(m.edge_handle(H(0))).deleted() && !twinedge::of(m).validate().valid(), "half-edge 0 is live, and wrong");
  trial::require(ok && deleted, "O1 is still there");
}

// O2: the same, with a face on either side.
static void collapse_hangs() {
  Mesh m = with_parallel_edges(of_faces(4, {{V(0), V(1), V(2), V(3)}, {V(3), V(2), V(1), V(0)}}));
  const bool ok = m.is_collapse_ok(H(2));
  const bool hangs = trial::in_child([&] { return m.collapse(H(2)), true; }, 200) == trial::hangs;
  std::printf("O2 two squares back to back with a doubled side: is_collapse_ok %d; collapse does not return: %d\n", ok, hangs);
  trial::require(ok && hangs, "O2 is still there");
}

// O3: the checker accepts targets that are wrong, and does not return on a wrong `next`.
static void checker_misses() {
  const Mesh sound = of_faces(4, {{V(0), V(1), V(2), V(3)}});
  int all = 0, accepted = 0;
  for (const H h : sound.halfedges())
    for (const V v : sound.vertices()) {
      Mesh m = sound;
      m.set_vertex_handle(h, v);
      if (v == sound.to_vertex_handle(h)) continue;
      trial::require(!twinedge::of(m).validate().valid(), "the mesh is broken");
      ++all, accepted += trial::in_child([&] { return checker(m); }) == trial::accepts;
    }
  int links = 0, hangs = 0;
  for (const H h : sound.halfedges())
    for (const H next : sound.halfedges()) {
      Mesh m = sound;
      m.set_next_halfedge_handle(h, next);
      if (next == sound.next_halfedge_handle(h)) continue;
      trial::require(!twinedge::of(m).validate().valid(), "the mesh is broken");
      ++links, hangs += trial::in_child([&] { return checker(m); }) == trial::hangs;
    }
  std::printf("O3 MeshCheckerT on a square: accepts %d of %d wrong targets; does not return on %d of %d wrong next half-edges\n", accepted,
              all, hangs, links);
  trial::require(accepted > 0 && hangs > 0, "O3 is still there");
}

int main() {
  std::printf("OpenMesh %d.%d\n", OM_GET_VER, OM_GET_MAJ);
  if (OM_GET_VER != 9 || OM_GET_MAJ != 0) std::puts("the findings are of OpenMesh 9.0; this is another version");
  collapse_leaves();
  collapse_hangs();
  checker_misses();
  return 0;
}
