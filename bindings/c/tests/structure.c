// The interface as a C program uses it: every type of column, every error, corruptions, structures of pointers.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <twinedge.h>

#define CHECK(condition) \
  do { \
    if (!(condition)) { \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      exit(1); \
    } \
  } while (0)

// A closed surface: two triangles, back to back.
static const int32_t ORIGIN[] = {0, 1, 1, 2, 2, 0}, TWIN[] = {1, 0, 3, 2, 5, 4}, NEXT[] = {2, 5, 4, 1, 0, 3},
                     PREV[] = {4, 3, 0, 5, 2, 1}, FACE[] = {0, 1, 0, 1, 0, 1}, LEAVING[] = {0, 2, 4}, KEPT[] = {0, 1};

static twinedge_structure *pillow(void) {
  twinedge_structure *s = twinedge_structure_new();
  CHECK(twinedge_column_i32(s, TWINEDGE_LINK_ORIGIN, ORIGIN, 6, 0) == TWINEDGE_STATUS_OK);
  CHECK(twinedge_column_i32(s, TWINEDGE_LINK_TWIN, TWIN, 6, 0) == TWINEDGE_STATUS_OK);
  CHECK(twinedge_column_i32(s, TWINEDGE_LINK_NEXT, NEXT, 6, 0) == TWINEDGE_STATUS_OK);
  CHECK(twinedge_column_i32(s, TWINEDGE_LINK_PREV, PREV, 6, 0) == TWINEDGE_STATUS_OK);
  CHECK(twinedge_column_i32(s, TWINEDGE_LINK_FACE, FACE, 6, 0) == TWINEDGE_STATUS_OK);
  CHECK(twinedge_column_i32(s, TWINEDGE_LINK_LEAVING, LEAVING, 3, 0) == TWINEDGE_STATUS_OK);
  CHECK(twinedge_column_i32(s, TWINEDGE_LINK_FACE_HALF_EDGE, KEPT, 2, 0) == TWINEDGE_STATUS_OK);
  return s;
}

// Frees the structure, and gives its report.
static twinedge_report *judge(twinedge_structure *s) {
  twinedge_report *r = NULL;
  twinedge_status status = twinedge_validate(s, &r);
  if (status != TWINEDGE_STATUS_OK) fprintf(stderr, "%d: %s\n", status, twinedge_structure_error(s));
  CHECK(status == TWINEDGE_STATUS_OK && r);
  twinedge_structure_free(s);
  return r;
}

// A valid structure with this number of something.
static void counts(twinedge_structure *s, twinedge_count what, uint64_t number) {
  twinedge_report *r = judge(s);
  if (!twinedge_report_valid(r)) fputs(twinedge_report_text(r), stderr);
  CHECK(twinedge_report_valid(r) && twinedge_report_count(r, what) == number);
  twinedge_report_free(r);
}

static void is_valid(twinedge_structure *s) { counts(s, TWINEDGE_COUNT_VIOLATIONS, 0); }

static void breaks(twinedge_structure *s, const char *rule) {
  twinedge_report *r = judge(s);
  CHECK(!twinedge_report_valid(r) && twinedge_report_listed(r) > 0);
  const char *found = twinedge_violation_rule(twinedge_report_violation(r, 0));
  if (strcmp(found, rule)) fputs(twinedge_report_text(r), stderr);
  CHECK(strcmp(found, rule) == 0);
  twinedge_report_free(r);
}

static void fails(twinedge_structure *s, twinedge_status status, const char *message) {
  twinedge_report *r = (twinedge_report *)s;
  CHECK(twinedge_validate(s, &r) == status && r == NULL);
  if (!strstr(twinedge_structure_error(s), message)) fprintf(stderr, "%s\n", twinedge_structure_error(s));
  CHECK(strstr(twinedge_structure_error(s), message));
  twinedge_structure_free(s);
}

static void reports(void) {
  twinedge_report *r = judge(pillow());
  static const uint64_t expected[] = {3, 6, 3, 2, 2, 0, 0, 1, 2, 0, 0, 0};
  for (int i = 0; i < 12; i++) CHECK(twinedge_report_count(r, i) == expected[i]);
  CHECK(twinedge_report_count(r, 12) == UINT64_MAX && twinedge_report_count(r, -1) == UINT64_MAX);
  CHECK(twinedge_report_listed(r) == 0 && twinedge_report_violation(r, 0) == NULL);
  CHECK(strstr(twinedge_report_json(r), "{\"schema\":\"twinedge-report/1\",\"valid\":true,") == twinedge_report_json(r));
  CHECK(strstr(twinedge_report_text(r), "R1 live"));
  twinedge_report_free(r);

  twinedge_structure *s = pillow();
  const int32_t twin[] = {2, 0, 3, 2, 5, 4};
  twinedge_column_i32(s, TWINEDGE_LINK_TWIN, twin, 6, 0);
  CHECK(twinedge_expect(s, TWINEDGE_EXPECTED_LIST, 1) == TWINEDGE_STATUS_OK);
  r = judge(s);
  CHECK(!twinedge_report_valid(r) && twinedge_report_listed(r) == 1);
  CHECK(twinedge_report_count(r, TWINEDGE_COUNT_VIOLATIONS) > 1);
  CHECK(twinedge_report_count(r, TWINEDGE_COUNT_GENUS) == UINT64_MAX);
  const twinedge_violation *v = twinedge_report_violation(r, 0);
  CHECK(!strcmp(twinedge_violation_rule(v), "L1") && !strcmp(twinedge_violation_kind(v), "twin_not_mutual"));
  CHECK(strstr(twinedge_violation_message(v), "half-edge 0 has twin 2"));
  CHECK(*twinedge_violation_cause(v) && *twinedge_violation_remedy(v));
  int kind = 9;
  size_t index = 9;
  CHECK(twinedge_violation_record(v, 0, &kind, &index) && kind == TWINEDGE_RECORD_HALF_EDGE && index == 0);
  CHECK(twinedge_violation_record(v, 0, NULL, NULL) && !twinedge_violation_record(v, 2, &kind, &index));
  CHECK(strstr(twinedge_report_json(r), "twin_not_mutual") && strstr(twinedge_report_text(r), "BROKEN"));
  twinedge_report_free(r);
}

// Records as an array of structs, read forwards and backwards.
typedef struct {
  double weight;
  uint64_t origin, next;
  char name[8];
} half_edge;

static void types_and_strides(void) {
  half_edge records[6];
  memset(records, 0x55, sizeof records);
  uint32_t origin32[6], next32[6];
  int64_t origin64[6], next64[6];
  for (int i = 0; i < 6; i++) {
    records[i].origin = origin32[i] = (uint32_t)(origin64[i] = ORIGIN[i]);
    records[i].next = next32[i] = (uint32_t)(next64[i] = NEXT[i]);
  }
  twinedge_structure *s = twinedge_structure_new();
  twinedge_column_u64(s, TWINEDGE_LINK_ORIGIN, &records->origin, 6, sizeof *records);
  twinedge_column_u64(s, TWINEDGE_LINK_NEXT, &records->next, 6, sizeof *records);
  is_valid(s);
  s = twinedge_structure_new();
  twinedge_column_u32(s, TWINEDGE_LINK_ORIGIN, origin32, 6, 0);
  twinedge_column_u32(s, TWINEDGE_LINK_NEXT, next32, 6, 4);
  is_valid(s);
  s = twinedge_structure_new();
  twinedge_column_i64(s, TWINEDGE_LINK_ORIGIN, origin64, 6, 0);
  twinedge_column_i64(s, TWINEDGE_LINK_NEXT, next64, 6, 0);
  is_valid(s);
  // By their targets, backwards: half-edge 5 - h is h, and twins stay pairs.
  int32_t target[6], next[6];
  for (int h = 0; h < 6; h++) target[h] = ORIGIN[h ^ 1], next[h] = 5 - NEXT[h];
  s = twinedge_structure_new();
  twinedge_column_i32(s, TWINEDGE_LINK_TARGET, target + 5, 6, -(ptrdiff_t)sizeof *target);
  twinedge_column_i32(s, TWINEDGE_LINK_NEXT, next + 5, 6, -(ptrdiff_t)sizeof *next);
  is_valid(s);
}

static void expectations(void) {
  for (int what = TWINEDGE_EXPECTED_PLANE; what <= TWINEDGE_EXPECTED_BORDER_KEPT; what++) {
    twinedge_structure *s = pillow();
    CHECK(twinedge_expect(s, what, 1) == TWINEDGE_STATUS_OK && twinedge_expect(s, what, 0) == TWINEDGE_STATUS_OK);
    is_valid(s);
  }
  static const struct {
    twinedge_expected what;
    size_t right, wrong;
    const char *rule;
  } numbers[] = {{TWINEDGE_EXPECTED_SIDES, 3, 4, "M3"},
                 {TWINEDGE_EXPECTED_COMPONENTS, 1, 2, "M5"},
                 {TWINEDGE_EXPECTED_BORDERS, 0, 1, "M6"},
                 {TWINEDGE_EXPECTED_GENUS, 0, 1, "M7"}};
  for (size_t i = 0; i < 4; i++) {
    twinedge_structure *s = pillow();
    twinedge_expect(s, numbers[i].what, numbers[i].right);
    is_valid(s);
    s = pillow();
    twinedge_expect(s, numbers[i].what, numbers[i].wrong);
    breaks(s, numbers[i].rule);
  }
  twinedge_structure *s = pillow();
  CHECK(twinedge_preset(s, "openmesh") == TWINEDGE_STATUS_OK);
  is_valid(s);
  // A triangle without the far side of its edges.
  static const int32_t none[] = {-1, -1, -1}, next[] = {1, 2, 0}, origin[] = {0, 1, 2}, zero[] = {0, 0, 0};
  for (int open = 0; open < 2; open++) {
    s = twinedge_structure_new();
    twinedge_column_i32(s, TWINEDGE_LINK_ORIGIN, origin, 3, 0);
    twinedge_column_i32(s, TWINEDGE_LINK_TWIN, none, 3, 0);
    twinedge_column_i32(s, TWINEDGE_LINK_NEXT, next, 3, 0);
    twinedge_column_i32(s, TWINEDGE_LINK_FACE, zero, 3, 0);
    twinedge_expect(s, TWINEDGE_EXPECTED_OPEN, (size_t)open);
    if (open) counts(s, TWINEDGE_COUNT_BORDERS, 1);
    else breaks(s, "R1");
  }
  s = pillow();
  twinedge_records(s, TWINEDGE_RECORD_VERTEX, 3);
  static const uint8_t live[] = {1, 0, 1};
  twinedge_live(s, TWINEDGE_RECORD_VERTEX, live, 3, 0);
  breaks(s, "R1");
  // A surface without column of twins, of faces or of vertices: a handle from each opposite side of a square.
  static const int32_t o[] = {0, 0, 0, 0}, n[] = {2, 3, 1, 0};
  s = twinedge_structure_new();
  twinedge_column_i32(s, TWINEDGE_LINK_ORIGIN, o, 4, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_NEXT, n, 4, 0);
  twinedge_expect(s, TWINEDGE_EXPECTED_GENUS, 1);
  counts(s, TWINEDGE_COUNT_GENUS, 1);
}

static const int32_t INNER[] = {1, 2};

// A triangle, with an isolated vertex inside. Face 0 is unbounded.
static twinedge_structure *of_boundaries(const int32_t *inner) {
  static const int32_t boundary[] = {0, 1, 0, 1, 0, 1}, isolated[] = {-1, -1, -1, 2}, face[] = {1, 0, 1},
                       half_edge_of[] = {0, 1, -1}, vertex[] = {-1, -1, 3}, outer[] = {-1, 0}, first[] = {0, 1, 2};
  twinedge_structure *s = twinedge_structure_new();
  twinedge_column_i32(s, TWINEDGE_LINK_ORIGIN, ORIGIN, 6, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_NEXT, NEXT, 6, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_BOUNDARY, boundary, 6, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_ISOLATED, isolated, 4, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_BOUNDARY_FACE, face, 3, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_BOUNDARY_HALF_EDGE, half_edge_of, 3, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_BOUNDARY_VERTEX, vertex, 3, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_OUTER, outer, 2, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_INNER_FIRST, first, 3, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_INNER, inner, 2, 0);
  return s;
}

static void boundary_components(void) {
  static const int32_t listed_twice[] = {1, 1};
  static const twinedge_count counted[] = {TWINEDGE_COUNT_OUTER_BOUNDARIES, TWINEDGE_COUNT_INNER_BOUNDARIES,
                                           TWINEDGE_COUNT_ISOLATED_VERTICES, TWINEDGE_COUNT_COMPONENTS};
  static const uint64_t numbers[] = {1, 2, 1, 2};
  for (int test = 0; test < 5; test++) {
    const int broken = test == 4;
    twinedge_structure *s = of_boundaries(broken ? listed_twice : INNER);
    twinedge_expect(s, TWINEDGE_EXPECTED_PLANE, 1);
    if (broken) breaks(s, "F2");
    else counts(s, counted[test], numbers[test]);
  }
}

static void errors(void) {
  twinedge_structure *s = twinedge_structure_new();
  CHECK(*twinedge_structure_error(s) == 0);
  CHECK(twinedge_column_i32(s, 16, ORIGIN, 6, 0) == TWINEDGE_STATUS_UNKNOWN);
  CHECK(twinedge_column_i32(s, TWINEDGE_LINK_NEXT, NULL, 6, 0) == TWINEDGE_STATUS_NULL);
  // The first failure stays, also when the same is done right.
  CHECK(twinedge_column_i32(s, TWINEDGE_LINK_NEXT, NEXT, 6, 0) == TWINEDGE_STATUS_OK);
  fails(s, TWINEDGE_STATUS_UNKNOWN, "there is no link with the number 16");
  fails(twinedge_structure_new(), TWINEDGE_STATUS_MISSING, "next: missing");
#define FAILS(call, status, message) \
  do { \
    s = pillow(); \
    CHECK((call) == TWINEDGE_STATUS_##status); \
    fails(s, TWINEDGE_STATUS_##status, message); \
  } while (0)
#define FAILS_LATE(call, status, message) \
  do { \
    s = pillow(); \
    CHECK((call) == TWINEDGE_STATUS_OK); \
    fails(s, TWINEDGE_STATUS_##status, message); \
  } while (0)
  const char *bytes = (const char *)ORIGIN;
  uint32_t other[6] = {0};
  FAILS(twinedge_column_i32(s, -1, ORIGIN, 6, 0), UNKNOWN, "there is no link with the number -1");
  FAILS(twinedge_column_i32(s, TWINEDGE_LINK_PREV, NULL, 6, 0), NULL, "prev: the pointer is null");
  FAILS(twinedge_column_i32(s, TWINEDGE_LINK_PREV, PREV, 6, 6), ALIGNMENT, "prev: the stride");
  FAILS(twinedge_column_i32(s, TWINEDGE_LINK_PREV, (const int32_t *)(const void *)(bytes + 1), 5, 0), ALIGNMENT,
        "prev: the cells are not aligned");
  FAILS(twinedge_column_i32(s, TWINEDGE_LINK_PREV, PREV, SIZE_MAX, 0), LENGTH, "do not fit into memory");
  FAILS(twinedge_column_i32(s, TWINEDGE_LINK_PREV, PREV, SIZE_MAX / 4, 0), LENGTH, "do not fit into memory");
  FAILS(twinedge_column_i32(s, TWINEDGE_LINK_PREV, PREV, 3, PTRDIFF_MIN), LENGTH, "do not fit into memory");
  FAILS(twinedge_column_u32(s, TWINEDGE_LINK_PREV, other, 6, 0), TYPE, "prev: the columns before are of another type");
  FAILS(twinedge_records(s, 4, 6), UNKNOWN, "there is no kind of record with the number 4");
  FAILS(twinedge_live(s, TWINEDGE_RECORD_FACE, NULL, 1, 0), NULL, "live: the pointer is null");
  FAILS(twinedge_pointers(s, TWINEDGE_RECORD_FACE, NULL, 1), NULL, "face: the pointer is null");
  FAILS(twinedge_follow(s, TWINEDGE_LINK_NEXT, NULL, NULL), NULL, "next: the function is null");
  FAILS(twinedge_follow_inner(s, NULL, NULL), NULL, "inner: the function is null");
  FAILS(twinedge_preset(s, NULL), NULL, "preset: the name is null");
  FAILS(twinedge_preset(s, "cgal"), UNKNOWN, "there are surface_mesh, openmesh");
  FAILS(twinedge_expect(s, 11, 1), UNKNOWN, "there is no expectation with the number 11");
  FAILS_LATE(twinedge_column_i32(s, TWINEDGE_LINK_ORIGIN, ORIGIN, 5, 0), LENGTH, "`origin` has length 5, where 6");
  FAILS_LATE(twinedge_column_i32(s, TWINEDGE_LINK_TARGET, ORIGIN, 6, 0), CONFLICT, "give either origin or target");
  FAILS_LATE(twinedge_column_i32(s, TWINEDGE_LINK_INNER, ORIGIN, 6, 0), CONFLICT, "inner: with boundary components");
  FAILS_LATE(twinedge_records(s, TWINEDGE_RECORD_HALF_EDGE, 7), LENGTH, "`next` has length 6, where 7");
  FAILS_LATE(twinedge_records(s, TWINEDGE_RECORD_VERTEX, 7), LENGTH, "`leaving` has length 3, where 7");
  FAILS_LATE(twinedge_live(s, TWINEDGE_RECORD_FACE, (const uint8_t *)bytes, 3, 0), LENGTH, "`live_faces`");
  FAILS_LATE(twinedge_pointers(s, TWINEDGE_RECORD_FACE, NULL, 0), CONFLICT, "either columns or records");
  s = pillow();
  twinedge_expect(s, TWINEDGE_EXPECTED_PLANE, 1);
  twinedge_preset(s, "openmesh");
  fails(s, TWINEDGE_STATUS_CONFLICT, "plane: a preset says");
  s = pillow();
  CHECK(twinedge_validate(s, NULL) == TWINEDGE_STATUS_NULL);
  fails(s, TWINEDGE_STATUS_NULL, "the place for the report is null");
  // The failed call is mended, and its sentence is gone. A column that is given again takes the place of the first.
  s = pillow();
  CHECK(twinedge_column_i32(s, TWINEDGE_LINK_PREV, PREV, 5, 0) == TWINEDGE_STATUS_OK);
  twinedge_report *mended = NULL;
  CHECK(twinedge_validate(s, &mended) == TWINEDGE_STATUS_LENGTH && *twinedge_structure_error(s));
  CHECK(twinedge_column_i32(s, TWINEDGE_LINK_PREV, PREV, 6, 0) == TWINEDGE_STATUS_OK);
  CHECK(twinedge_validate(s, &mended) == TWINEDGE_STATUS_OK && twinedge_report_valid(mended));
  CHECK(*twinedge_structure_error(s) == 0);
  twinedge_report_free(mended);
  twinedge_structure_free(s);
  // No structure: no call does more than say so.
  twinedge_report *r = (twinedge_report *)(void *)other;
  CHECK(twinedge_validate(NULL, &r) == TWINEDGE_STATUS_NULL && r == NULL);
  CHECK(twinedge_column_i32(NULL, 0, ORIGIN, 6, 0) == TWINEDGE_STATUS_NULL);
  CHECK(twinedge_preset(NULL, "openmesh") == TWINEDGE_STATUS_NULL && *twinedge_structure_error(NULL) == 0);
  CHECK(!twinedge_report_valid(NULL) && twinedge_report_count(NULL, 0) == UINT64_MAX && !twinedge_report_text(NULL));
  CHECK(!twinedge_report_json(NULL) && twinedge_report_listed(NULL) == 0 && !twinedge_report_violation(NULL, 0));
  CHECK(!twinedge_violation_rule(NULL) && !twinedge_violation_record(NULL, 0, NULL, NULL));
  twinedge_structure_free(NULL);
  twinedge_report_free(NULL);
}

// Checks the text of a report, in words of the header.
static void says(twinedge_structure *s, const char *text, const char *json) {
  twinedge_report *r = judge(s);
  const char *all = twinedge_report_text(r);
  if (!strstr(all, text)) fprintf(stderr, "%s\n", all);
  CHECK(strstr(all, text) && !strstr(all, "Expectation") && !strstr(all, "expectation") && !strstr(all, "View") &&
        !strstr(all, "face_slots"));
  if (!strstr(twinedge_report_json(r), json)) fprintf(stderr, "%s\n", twinedge_report_json(r));
  CHECK(strstr(twinedge_report_json(r), json));
  twinedge_report_free(r);
}

static void words(void) {
  static const int32_t nils[] = {-1, -1, -1, -1, -1, -1}, far[] = {0, 1, 0, -7, 0, 1}, least[] = {INT32_MIN, 2, 4};
  twinedge_structure *s = twinedge_structure_new();
  twinedge_column_i32(s, TWINEDGE_LINK_ORIGIN, ORIGIN, 6, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_NEXT, NEXT, 6, 0);
  says(s, "V1 leaving   not checked: TWINEDGE_LINK_LEAVING was not given", "\"unchecked\":{\"lacks\":\"leaving\"}");
  s = twinedge_structure_new();
  twinedge_column_i32(s, TWINEDGE_LINK_ORIGIN, ORIGIN, 6, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_NEXT, NEXT, 6, 0);
  says(s, "L1 twin      ok, 6 half-edges (twin: h ^ 1, as TWINEDGE_LINK_TWIN was not given)\n", "\"id\":\"L1\"");
  twinedge_report *r = judge(pillow());
  CHECK(!strstr(twinedge_report_text(r), "h ^ 1"));
  twinedge_report_free(r);
  s = pillow();
  twinedge_preset(s, "trimesh");
  says(s, "V1 leaving   ok, 3 vertices", "");
  says(of_boundaries(INNER), "B1 cycle     ok", "{\"id\":\"B2\",\"checked\":0,\"violations\":0,\"unchecked\":\"plane_only\"}");
  // Hints.
  s = pillow();
  twinedge_column_i32(s, TWINEDGE_LINK_PREV, nils, 6, 0);
  says(s, "stores no prev links, do not give `TWINEDGE_LINK_PREV`", "\"kind\":\"nil\"");
  s = pillow();
  twinedge_column_i32(s, TWINEDGE_LINK_FACE, nils, 6, 0);
  says(s, "stores no faces, do not give `TWINEDGE_LINK_FACE`", "");
  s = pillow();
  twinedge_column_i32(s, TWINEDGE_LINK_LEAVING, nils, 3, 0);
  says(s, "stores no leaving half-edges, do not give `TWINEDGE_LINK_LEAVING`", "");
  s = pillow();
  twinedge_column_i32(s, TWINEDGE_LINK_TWIN, nils, 6, 0);
  says(s, "if the structure has a border, expect `TWINEDGE_EXPECTED_OPEN`", "");
  s = pillow();
  twinedge_records(s, TWINEDGE_RECORD_FACE, 0);
  twinedge_column_i32(s, TWINEDGE_LINK_FACE_HALF_EDGE, NULL, 0, 0);
  says(s, "there are none; give their number by `twinedge_records`", "");
  // Numbers that are no index.
  s = pillow();
  twinedge_column_i32(s, TWINEDGE_LINK_FACE, far, 6, 0);
  says(s, "the face of half-edge 3 is -7, which is no live record", "\"field\":\"face\",\"value\":-7}");
  s = pillow();
  twinedge_column_i32(s, TWINEDGE_LINK_LEAVING, least, 3, 0);
  says(s, "the leaving half-edge of vertex 0 is -2147483648, which", "\"value\":-2147483648}");
  int64_t origin[6], next[6], target[6];
  for (int h = 0; h < 6; h++) origin[h] = ORIGIN[h], next[h] = NEXT[h], target[h] = ORIGIN[h ^ 1];
  static const int64_t wide[] = {INT64_MIN, 9007199254740992, 9007199254740991, -9007199254740992};
  static const char *const text[] = {"is -9223372036854775808, which", "is 9007199254740992, which", "is 9007199254740991, which",
                                     "is -9007199254740992, which"};
  static const char *const json[] = {"\"value\":\"-9223372036854775808\"}", "\"value\":\"9007199254740992\"}",
                                     "\"value\":9007199254740991}", "\"value\":\"-9007199254740992\"}"};
  for (int i = 0; i < 4; i++) {
    next[2] = wide[i];
    s = twinedge_structure_new();
    twinedge_column_i64(s, TWINEDGE_LINK_ORIGIN, origin, 6, 0);
    twinedge_column_i64(s, TWINEDGE_LINK_NEXT, next, 6, 0);
    says(s, text[i], json[i]);
  }
  // The origin of half-edge 4 is the target of half-edge 5.
  next[2] = NEXT[2], target[5] = -3;
  s = twinedge_structure_new();
  twinedge_column_i64(s, TWINEDGE_LINK_TARGET, target, 6, 0);
  twinedge_column_i64(s, TWINEDGE_LINK_NEXT, next, 6, 0);
  says(s, "the origin of half-edge 4 is -3, which", "\"value\":-3}");
}

// A triangle in the plane: every face has a half-edge, or the outside has no record.
static void faces_in_the_plane(void) {
  static const int32_t nil_outside[] = {0, -1, 0, -1, 0, -1}, kept_nil[] = {0, -1};
  for (int test = 0; test < 4; test++) {
    twinedge_structure *s = twinedge_structure_new();
    twinedge_column_i32(s, TWINEDGE_LINK_ORIGIN, ORIGIN, 6, 0);
    twinedge_column_i32(s, TWINEDGE_LINK_NEXT, NEXT, 6, 0);
    twinedge_column_i32(s, TWINEDGE_LINK_FACE, test < 2 ? FACE : nil_outside, 6, 0);
    twinedge_column_i32(s, TWINEDGE_LINK_FACE_HALF_EDGE, test == 1 ? kept_nil : KEPT, test < 2 ? 2 : 1, 0);
    twinedge_expect(s, TWINEDGE_EXPECTED_PLANE, 1);
    twinedge_expect(s, TWINEDGE_EXPECTED_OPEN, test == 2);
    if (test % 2 == 0) is_valid(s);
    else if (test == 1) says(s, "`TWINEDGE_LINK_FACE_HALF_EDGE` (or `TWINEDGE_LINK_OUTER`) is nil", "\"kind\":\"no_outer\"");
    else breaks(s, "R1");
  }
}

// Every value in every cell: each ends, and the sound one is the only one without violation among the columns of links.
static void corruptions(void) {
  static const int32_t *const columns[] = {ORIGIN, TWIN, NEXT, PREV, FACE, LEAVING, KEPT};
  static const int links[] = {TWINEDGE_LINK_ORIGIN, TWINEDGE_LINK_TWIN, TWINEDGE_LINK_NEXT, TWINEDGE_LINK_PREV,
                              TWINEDGE_LINK_FACE, TWINEDGE_LINK_LEAVING, TWINEDGE_LINK_FACE_HALF_EDGE};
  static const size_t lengths[] = {6, 6, 6, 6, 6, 3, 2};
  static const int32_t values[] = {-1, -2, 0, 1, 2, 3, 4, 5, 6, INT32_MAX, INT32_MIN};
  int caught = 0, legal = 0;
  for (size_t c = 0; c < 7; c++) {
    for (size_t i = 0; i < lengths[c]; i++) {
      for (size_t v = 0; v < sizeof values / sizeof *values; v++) {
        if (values[v] == columns[c][i]) continue;
        int32_t changed[6];
        memcpy(changed, columns[c], lengths[c] * sizeof *changed);
        changed[i] = values[v];
        twinedge_structure *s = pillow();
        twinedge_column_i32(s, links[c], changed, lengths[c], 0);
        twinedge_report *r = judge(s);
        int valid = twinedge_report_valid(r);
        // Another half-edge of the same vertex or face is legal.
        CHECK(!valid || links[c] == TWINEDGE_LINK_LEAVING || links[c] == TWINEDGE_LINK_FACE_HALF_EDGE);
        caught += !valid, legal += valid;
        twinedge_report_free(r);
      }
    }
  }
  CHECK(caught == 343 && legal == 7);
}

// The same surface as records joined by pointers.
typedef struct node {
  struct node *origin, *twin, *next, *prev, *face, *kept;
} node;

static node vertices[3], half_edges[6], faces[2];

static void link_nodes(void) {
  for (int h = 0; h < 6; h++) {
    half_edges[h] = (node){&vertices[ORIGIN[h]], &half_edges[TWIN[h]], &half_edges[NEXT[h]], &half_edges[PREV[h]],
                           &faces[FACE[h]], NULL};
  }
  for (int v = 0; v < 3; v++) vertices[v].kept = &half_edges[LEAVING[v]];
  for (int f = 0; f < 2; f++) faces[f].kept = &half_edges[KEPT[f]];
}

static int called;
#define FIELD(name) \
  static const void *name##_of(void *context, const void *record) { \
    called += context == &called; \
    return ((const node *)record)->name; \
  }
FIELD(origin)
FIELD(twin)
FIELD(next)
FIELD(prev)
FIELD(face)
FIELD(kept)

static twinedge_structure *of_nodes(void) {
  static const void *v[3], *h[6], *f[2];
  for (int i = 0; i < 6; i++) h[i] = &half_edges[i];
  for (int i = 0; i < 3; i++) v[i] = &vertices[i];
  for (int i = 0; i < 2; i++) f[i] = &faces[i];
  twinedge_structure *s = twinedge_structure_new();
  twinedge_pointers(s, TWINEDGE_RECORD_VERTEX, v, 3);
  twinedge_pointers(s, TWINEDGE_RECORD_HALF_EDGE, h, 6);
  twinedge_pointers(s, TWINEDGE_RECORD_FACE, f, 2);
  twinedge_follow(s, TWINEDGE_LINK_ORIGIN, origin_of, &called);
  twinedge_follow(s, TWINEDGE_LINK_TWIN, twin_of, &called);
  twinedge_follow(s, TWINEDGE_LINK_NEXT, next_of, &called);
  twinedge_follow(s, TWINEDGE_LINK_PREV, prev_of, &called);
  twinedge_follow(s, TWINEDGE_LINK_FACE, face_of, &called);
  twinedge_follow(s, TWINEDGE_LINK_LEAVING, kept_of, &called);
  twinedge_follow(s, TWINEDGE_LINK_FACE_HALF_EDGE, kept_of, &called);
  return s;
}

static bool endless(void *context, const void *face, size_t position, const void **inner) {
  (void)face, (void)position;
  ++*(int *)context;
  *inner = &called;
  return true;
}

static void pointers(void) {
  link_nodes();
  is_valid(of_nodes());
  CHECK(called == 5 * 6 + 3 + 2);
  // Links to a record of another kind, to nowhere, to nothing.
  node *garbage[] = {&vertices[0], (node *)(void *)&called, (node *)(uintptr_t)1, NULL};
  for (int i = 0; i < 4; i++) {
    half_edges[2].next = garbage[i];
    breaks(of_nodes(), "R1");
    if (garbage[i]) says(of_nodes(), "the next of half-edge 2 leads to what is not in the list", "\"value\":\"none\"}");
  }
  link_nodes();
  half_edges[2].next = &half_edges[3];
  breaks(of_nodes(), "L2");
  link_nodes();

  twinedge_structure *s = of_nodes();
  CHECK(twinedge_follow(s, TWINEDGE_LINK_INNER, next_of, NULL) == TWINEDGE_STATUS_UNKNOWN);
  fails(s, TWINEDGE_STATUS_UNKNOWN, "inner: no link of one record");
  const void *twice[] = {&vertices[0], &vertices[1], &vertices[0]}, *null[] = {&vertices[0], NULL};
  s = of_nodes();
  twinedge_pointers(s, TWINEDGE_RECORD_VERTEX, twice, 3);
  fails(s, TWINEDGE_STATUS_CONFLICT, "the vertex 2 is given before, as vertex 0");
  s = of_nodes();
  twinedge_pointers(s, TWINEDGE_RECORD_VERTEX, null, 2);
  fails(s, TWINEDGE_STATUS_NULL, "the vertex 1 is null");

  // Faces with endless lists of what is no boundary component.
  static const void *h[6], *f[2], *v[3];
  for (int i = 0; i < 6; i++) h[i] = &half_edges[i];
  for (int i = 0; i < 3; i++) v[i] = &vertices[i];
  for (int i = 0; i < 2; i++) f[i] = &faces[i];
  int asked = 0;
  s = twinedge_structure_new();
  twinedge_pointers(s, TWINEDGE_RECORD_HALF_EDGE, h, 6);
  twinedge_pointers(s, TWINEDGE_RECORD_FACE, f, 2);
  twinedge_pointers(s, TWINEDGE_RECORD_VERTEX, v, 3);
  twinedge_pointers(s, TWINEDGE_RECORD_BOUNDARY, NULL, 0);
  twinedge_follow(s, TWINEDGE_LINK_ORIGIN, origin_of, NULL);
  twinedge_follow(s, TWINEDGE_LINK_TWIN, twin_of, NULL);
  twinedge_follow(s, TWINEDGE_LINK_NEXT, next_of, NULL);
  twinedge_follow(s, TWINEDGE_LINK_BOUNDARY, face_of, NULL);
  twinedge_follow(s, TWINEDGE_LINK_BOUNDARY_FACE, face_of, NULL);
  twinedge_follow(s, TWINEDGE_LINK_BOUNDARY_HALF_EDGE, kept_of, NULL);
  twinedge_follow(s, TWINEDGE_LINK_OUTER, kept_of, NULL);
  twinedge_follow_inner(s, endless, &asked);
  twinedge_expect(s, TWINEDGE_EXPECTED_PLANE, 1);
  breaks(s, "R1");
  CHECK(asked == 17);
}

// Each list and each link that is needed, left out in turn.
static void lists_that_are_missing(void) {
  static const int kinds[] = {TWINEDGE_RECORD_VERTEX, TWINEDGE_RECORD_HALF_EDGE, TWINEDGE_RECORD_FACE};
  static const int links[] = {TWINEDGE_LINK_ORIGIN, TWINEDGE_LINK_NEXT, TWINEDGE_LINK_TWIN, TWINEDGE_LINK_FACE};
  static const twinedge_link_of functions[] = {origin_of, next_of, twin_of, face_of};
  static const char *const messages[] = {"origin: needs the list of vertices", "origin: needs the list of half-edges",
                                         "face: needs the list of faces",      "give either origin or target",
                                         "next: missing",                      "twin: missing"};
  static const void *v[3], *h[6], *f[2];
  for (int i = 0; i < 6; i++) h[i] = &half_edges[i];
  for (int i = 0; i < 3; i++) v[i] = &vertices[i];
  for (int i = 0; i < 2; i++) f[i] = &faces[i];
  const void **const lists[] = {v, h, f};
  static const size_t sizes[] = {3, 6, 2};
  for (int left_out = 0; left_out < 7; left_out++) {
    twinedge_structure *s = twinedge_structure_new();
    for (int i = 0; i < 3; i++)
      if (i != left_out) twinedge_pointers(s, kinds[i], lists[i], sizes[i]);
    for (int i = 0; i < 4; i++)
      if (i + 3 != left_out) twinedge_follow(s, links[i], functions[i], NULL);
    if (left_out == 6) is_valid(s);  // Faces are listed, and none names them.
    else fails(s, TWINEDGE_STATUS_MISSING, messages[left_out]);
  }
  // Faces that list boundary components, of which there is no list.
  int asked = 0;
  twinedge_structure *s = of_nodes();
  twinedge_follow_inner(s, endless, &asked);
  fails(s, TWINEDGE_STATUS_MISSING, "inner: needs the list of boundary components");
  CHECK(asked == 0);
}

int main(void) {
  CHECK(strcmp(twinedge_version(), "0.1.0") == 0);
  is_valid(pillow());
  reports();
  types_and_strides();
  expectations();
  boundary_components();
  errors();
  words();
  faces_in_the_plane();
  corruptions();
  pointers();
  lists_that_are_missing();
  puts("structure.c: all is well");
  return 0;
}
