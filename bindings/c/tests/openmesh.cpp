// OpenMesh: sound meshes, and single corruptions through its public interface, beside its own checker.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/config.hh>
#include <OpenMesh/Tools/Utils/MeshCheckerT.hh>
#include <sstream>

#include <twinedge/openmesh.hpp>

#include "trial.hpp"

using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using V = OpenMesh::VertexHandle;
using H = OpenMesh::HalfedgeHandle;
using F = OpenMesh::FaceHandle;

// A grid of n × n squares.
template <class Mesh>
static Mesh grid(int n) {
  Mesh m;
  m.reserve(std::size_t((n + 1) * (n + 1)), std::size_t(2 * n * (n + 1)), std::size_t(n * n));
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) m.add_vertex(typename Mesh::Point(float(x), float(y), 0));
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int v = y * (n + 1) + x;
      m.add_face({V(v), V(v + 1), V(v + n + 2), V(v + n + 1)});
    }
  return m;
}

static bool theirs(const Mesh &m) {
  std::ostringstream ignored;
  return OpenMesh::Utils::MeshCheckerT<Mesh>(m).check(OpenMesh::Utils::MeshCheckerT<Mesh>::CHECK_ALL, ignored);
}

// Every link set to every other value for which a rule is broken.
static std::vector<trial::row> corrupt(const Mesh &sound) {
  std::vector<trial::row> rows;
  const auto change = [&](auto &&apply) {
    Mesh m = sound;
    apply(m);
    rows.back().judge(twinedge::of(m), [&] { return theirs(m); });
  };
  const int vertices = int(sound.n_vertices()), half_edges = int(sound.n_halfedges()), faces = int(sound.n_faces());
  // `set_next_halfedge_handle` sets `prev` of the other one, too. Both setters refuse nil.
  rows.push_back({"`next` of a half-edge, and `prev` of that"});
  for (int i = 0; i < half_edges; ++i)
    for (int j = 0; j < half_edges; ++j)
      if (H(j) != sound.next_halfedge_handle(H(i))) change([&](Mesh &m) { m.set_next_halfedge_handle(H(i), H(j)); });
  rows.push_back({"`prev` of a half-edge"});
  for (int i = 0; i < half_edges; ++i)
    for (int j = 0; j < half_edges; ++j)
      if (H(j) != sound.prev_halfedge_handle(H(i))) change([&](Mesh &m) { m.set_prev_halfedge_handle(H(i), H(j)); });
  rows.push_back({"target of a half-edge"});
  for (int i = 0; i < half_edges; ++i)
    for (int j = -1; j < vertices; ++j)
      if (V(j) != sound.to_vertex_handle(H(i))) change([&](Mesh &m) { m.set_vertex_handle(H(i), V(j)); });
  rows.push_back({"face of a half-edge"});
  for (int i = 0; i < half_edges; ++i)
    for (int j = -1; j < faces; ++j)
      if (F(j) != sound.face_handle(H(i))) change([&](Mesh &m) { m.set_face_handle(H(i), F(j)); });
  rows.push_back({"half-edge of a vertex, to one that starts elsewhere"});
  for (int i = 0; i < vertices; ++i)
    for (int j = -1; j < half_edges; ++j)
      if (j < 0 || sound.from_vertex_handle(H(j)) != V(i)) change([&](Mesh &m) { m.set_halfedge_handle(V(i), H(j)); });
  rows.push_back({"half-edge of a border vertex, to one inside"});
  for (int i = 0; i < vertices; ++i)
    for (int j = 0; j < half_edges; ++j)
      if (sound.is_boundary(V(i)) && sound.from_vertex_handle(H(j)) == V(i) && !sound.is_boundary(H(j)))
        change([&](Mesh &m) { m.set_halfedge_handle(V(i), H(j)); });
  rows.push_back({"half-edge of a face, to one of another face"});
  for (int i = 0; i < faces; ++i)
    for (int j = -1; j < half_edges; ++j)
      if (j < 0 || sound.face_handle(H(j)) != F(i)) change([&](Mesh &m) { m.set_halfedge_handle(F(i), H(j)); });
  return rows;
}

int main() {
  std::printf("\nOpenMesh %d.%d:\n", OM_GET_VER, OM_GET_MAJ);
  // Deleted elements are skipped; triangles are meshes, too.
  auto holed = grid<OpenMesh::TriMesh_ArrayKernelT<>>(6);
  holed.request_vertex_status(), holed.request_edge_status(), holed.request_face_status();
  holed.delete_face(F(28)), holed.delete_face(F(29)), holed.delete_face(F(0)), holed.delete_face(F(1));
  const auto report = twinedge::of(holed).validate();
  if (!report.valid()) std::fputs(report.text(), stderr);
  trial::require(report.valid() && report.count(TWINEDGE_COUNT_BORDERS) == 2, "a grid with a hole");
  trial::require(report.count(TWINEDGE_COUNT_VERTICES) == 48 && report.count(TWINEDGE_COUNT_FACES) == 68, "vacant slots");

  trial::table("`PolyMesh`", "`MeshCheckerT`", corrupt(grid<Mesh>(2)));
  // Last, as the corruptions fork this process.
  trial::healthy_header("`MeshCheckerT`");
  for (const int n : {158, 500}) {
    const Mesh m = grid<Mesh>(n);
    trial::healthy("PolyMesh", std::size_t(4 * n * (n + 1)), [&] { return twinedge::of(m); }, [&] { return theirs(m); });
  }
  return 0;
}
