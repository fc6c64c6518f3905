// Removal and connection at random places by CGAL's Euler operators, for comparison with `remove_edge` and `connect` in the group
// "pairs of triangles" of `edit.rs`, which describes the workload. The argument is the side of the grid.
//
//     apt-get install libcgal-dev
//     g++ -std=c++17 -O3 -DNDEBUG -DCGAL_DISABLE_GMP benches/peers.cpp -o peers && ./peers 400
//
// Both programs use the C library's allocator without huge pages. A `Surface_mesh` is columns of records, a `Polyhedron_3` lists of
// them. Neither has keys that become stale, holes in faces, or a log.

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <unordered_map>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;

template <class G> G grid(std::size_t side) {
    using Traits = boost::graph_traits<G>;
    G g;
    std::vector<typename Traits::vertex_descriptor> at(side * side);
    for (auto &v : at) v = add_vertex(g);
    for (std::size_t y = 0; y + 1 < side; ++y)
        for (std::size_t x = 0; x + 1 < side; ++x) {
            const auto i = y * side + x;
            const auto a = at[i], b = at[i + 1], c = at[i + 1 + side], d = at[i + side];
            CGAL::Euler::add_face(std::array{a, b, c}, g);
            CGAL::Euler::add_face(std::array{a, c, d}, g);
        }
    return g;
}

// Times removing edges between disjoint pairs of triangles in random order, and connecting their corners again in another order.
template <class G> void run(const char *name, std::size_t side, int rounds) {
    using Traits = boost::graph_traits<G>;
    using HalfEdge = typename Traits::halfedge_descriptor;
    double best[2] = {1e9, 1e9};
    std::size_t count = 0;
    const G original = grid<G>(side);
    for (int round = 0; round < rounds; ++round) {
        G g = original;
        std::mt19937_64 random(1);
        std::vector<HalfEdge> all, gone;
        for (auto e : edges(g)) all.push_back(halfedge(e, g));
        std::shuffle(all.begin(), all.end(), random);
        std::unordered_map<typename Traits::face_descriptor, bool> used;
        for (auto h : all) {
            const auto t = opposite(h, g);
            if (is_border(h, g) || is_border(t, g) || used[face(h, g)] || used[face(t, g)]) continue;
            used[face(h, g)] = used[face(t, g)] = true;
            gone.push_back(h);
        }
        count = gone.size();
        std::vector<std::array<HalfEdge, 2>> corners;
        for (auto h : gone) corners.push_back({prev(h, g), prev(opposite(h, g), g)});
        std::shuffle(corners.begin(), corners.end(), random);
        const auto time = [&](int which, auto &&each) {
            const auto start = std::chrono::steady_clock::now();
            each();
            const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
            best[which] = std::min(best[which], taken.count() / double(count));
        };
        time(0, [&] { for (auto h : gone) CGAL::Euler::join_face(h, g); });
        time(1, [&] { for (auto [a, b] : corners) CGAL::Euler::split_face(a, b, g); });
        if (num_faces(g) != num_faces(original)) std::abort();
    }
    std::printf("%-14s %zu operators: join_face %.1f ns, split_face %.1f ns\n", name, count, best[0], best[1]);
}

int main(int argc, char **argv) {
    const std::size_t side = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 400;
    run<CGAL::Surface_mesh<Kernel::Point_3>>("Surface_mesh", side, 7);
    run<CGAL::Polyhedron_3<Kernel>>("Polyhedron_3", side, 7);
}
