// twinedge::of(mesh): a PolyMesh or TriMesh of OpenMesh as columns. What is deleted and not yet collected is a vacant slot. O(n).
#pragma once
#include "twinedge.hpp"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <type_traits>

namespace twinedge {

template <class Mesh, class = std::enable_if_t<std::is_base_of_v<OpenMesh::PolyConnectivity, Mesh>>>
structure of(const Mesh &m) {
  const auto number = [](auto handle) { return static_cast<std::uint32_t>(handle.idx()); };  // −1 is nil.
  const std::size_t vertices = m.n_vertices(), half_edges = m.n_halfedges(), faces = m.n_faces();
  std::vector<std::uint32_t> origin(half_edges), next(half_edges), prev(half_edges), face(half_edges);
  std::vector<std::uint32_t> leaving(vertices), kept(faces);
  std::vector<std::uint8_t> live_vertices(vertices), live_half_edges(half_edges), live_faces(faces);
  for (std::size_t i = 0; i < half_edges; ++i) {
    const OpenMesh::HalfedgeHandle h(static_cast<int>(i));
    origin[i] = number(m.from_vertex_handle(h));
    next[i] = number(m.next_halfedge_handle(h));
    prev[i] = number(m.prev_halfedge_handle(h));
    face[i] = number(m.face_handle(h));
    live_half_edges[i] = !(m.has_edge_status() && m.status(m.edge_handle(h)).deleted());
  }
  for (std::size_t i = 0; i < vertices; ++i) {
    const OpenMesh::VertexHandle v(static_cast<int>(i));
    leaving[i] = number(m.halfedge_handle(v));
    live_vertices[i] = !(m.has_vertex_status() && m.status(v).deleted());
  }
  for (std::size_t i = 0; i < faces; ++i) {
    const OpenMesh::FaceHandle f(static_cast<int>(i));
    kept[i] = number(m.halfedge_handle(f));
    live_faces[i] = !(m.has_face_status() && m.status(f).deleted());
  }
  structure s;
  s.column(TWINEDGE_LINK_ORIGIN, std::move(origin)).column(TWINEDGE_LINK_NEXT, std::move(next));
  s.column(TWINEDGE_LINK_PREV, std::move(prev)).column(TWINEDGE_LINK_FACE, std::move(face));
  s.column(TWINEDGE_LINK_LEAVING, std::move(leaving)).column(TWINEDGE_LINK_FACE_HALF_EDGE, std::move(kept));
  s.live(TWINEDGE_RECORD_VERTEX, std::move(live_vertices)).live(TWINEDGE_RECORD_FACE, std::move(live_faces));
  return std::move(s.live(TWINEDGE_RECORD_HALF_EDGE, std::move(live_half_edges)).preset("openmesh"));
}

}  // namespace twinedge
