// The interface for C++ alone, without another library: structures of pointers, functions that throw, violations, errors.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <twinedge/twinedge.hpp>

static void require(bool holds, const char *what) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::exit(1);
}

struct half_edge;
struct vertex {
  half_edge *leaving;
};
struct half_edge {
  vertex *origin;
  half_edge *twin, *next;
};

// A triangle, and its outside.
struct triangle {
  vertex v[3];
  half_edge h[6];
  triangle() {
    const int origin[] = {0, 1, 1, 2, 2, 0}, next[] = {2, 5, 4, 1, 0, 3};
    for (int i = 0; i < 6; ++i) h[i] = {&v[origin[i]], &h[i ^ 1], &h[next[i]]};
    for (int i = 0; i < 3; ++i) v[i].leaving = &h[2 * i];
  }
};

// `calls` counts those of `next`, of which the one with the number `bad` throws.
static twinedge::structure of(const triangle &t, int &calls, int bad) {
  twinedge::structure s;
  s.pointers(TWINEDGE_RECORD_VERTEX, {&t.v[0], &t.v[1], &t.v[2]});
  s.pointers(TWINEDGE_RECORD_HALF_EDGE, {&t.h[0], &t.h[1], &t.h[2], &t.h[3], &t.h[4], &t.h[5]});
  s.follow<half_edge>(TWINEDGE_LINK_ORIGIN, [](const half_edge &h) { return h.origin; });
  s.follow<half_edge>(TWINEDGE_LINK_TWIN, [](const half_edge &h) { return h.twin; });
  s.follow<half_edge>(TWINEDGE_LINK_NEXT, [&calls, bad](const half_edge &h) {
    if (calls++ == bad) throw std::out_of_range("from a function of the caller");
    return h.next;
  });
  return std::move(s.follow<vertex>(TWINEDGE_LINK_LEAVING, [](const vertex &v) { return v.leaving; }));
}

static void exceptions(triangle &t) {
  for (int bad = 0; bad < 7; ++bad) {
    int calls = 0;
    auto structure = of(t, calls, bad);
    std::string caught;
    try {
      require(structure.validate().valid(), "a triangle is valid");
    } catch (const std::out_of_range &error) {
      caught = error.what();
    }
    require((caught == "from a function of the caller") == (bad < 6), "what a function throws comes out of validate()");
    require(calls == (bad < 6 ? bad + 1 : 6), "no function is called after it");
    calls = 100;
    require(structure.validate().valid(), "a later validation is a new one");
  }
  // An exception from the list of a face.
  twinedge::structure s;
  const int face = 0, boundary = 0;
  s.pointers(TWINEDGE_RECORD_VERTEX, {&t.v[0]}).pointers(TWINEDGE_RECORD_HALF_EDGE, {&t.h[0]});
  s.pointers(TWINEDGE_RECORD_FACE, {&face}).pointers(TWINEDGE_RECORD_BOUNDARY, {&boundary});
  s.follow<half_edge>(TWINEDGE_LINK_TWIN, [](const half_edge &h) { return h.twin; });
  s.follow<half_edge>(TWINEDGE_LINK_NEXT, [](const half_edge &h) { return h.next; });
  s.follow_inner<int>([](const int &, std::size_t position) -> const int * {
    if (position == 1) throw position;
    static const int nothing = 0;
    return &nothing;
  });
  std::size_t thrown = 0;
  try {
    s.validate();
  } catch (std::size_t position) {
    thrown = position;
  }
  require(thrown == 1, "an exception of any type, of a list");
}

static void violations(triangle &t) {
  int calls = 0;
  t.h[2].next = &t.h[3], t.v[1].leaving = &t.h[0];
  const auto report = of(t, calls, -1).validate();
  t.h[2].next = &t.h[4], t.v[1].leaving = &t.h[2];
  std::size_t seen = 0;
  for (const auto &violation : report.violations()) {
    ++seen;
    require(*violation.rule() && *violation.kind() && *violation.message() && *violation.cause() && *violation.remedy(), "words");
  }
  require(!report.valid() && seen > 1 && seen == report.count(TWINEDGE_COUNT_VIOLATIONS), "all violations");
  const auto first = report.violations().front();
  require(std::strcmp(first.kind(), "next_shared") == 0, first.kind());
  const auto record = first.record();
  require(record && record->kind == TWINEDGE_RECORD_HALF_EDGE && !first.record(2), "its record");
}

static void errors() {
  twinedge::structure s;
  s.column(TWINEDGE_LINK_NEXT, {0}).preset("nobody");
  int status = 0;
  try {
    s.validate();
  } catch (const twinedge::error &error) {
    status = error.status;
    require(std::strstr(error.what(), "there is none named"), error.what());
  }
  require(status == TWINEDGE_STATUS_UNKNOWN, "the status of an exception");
}

int main() {
  triangle t;
  exceptions(t);
  violations(t);
  errors();
  std::puts("cpp.cpp: all is well");
  return 0;
}
