// twinedge: a validator for half-edge structures. README.md has examples.
//
// A caller promises three things: a handle comes from this library and was not freed; a pointer that is not null leads to as much
// memory as its count and stride say, until twinedge_validate returns; a structure is used by one thread at a time. All else is
// checked: null, alignment, lengths, numbers that name nothing. Links are data, and may be anything.
//
// No function throws, and none panics into its caller. A null handle is an error where a status is returned, and nothing, 0,
// false or a null pointer where none is.

#ifndef TWINEDGE_H
#define TWINEDGE_H

// Made by cbindgen from bindings/c/src. To make it again: UPDATE_HEADER=1 cargo test --test header.

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// The result of a call: 0, or the reason why it failed.
typedef enum {
  // All is well. Of `twinedge_validate`: there is a report, whether the structure is valid or not.
  TWINEDGE_STATUS_OK,
  // A pointer is null.
  TWINEDGE_STATUS_NULL,
  // A number or a name that means nothing here: of a link, a kind of record, an expectation, a preset.
  TWINEDGE_STATUS_UNKNOWN,
  // A column has another length than there are records, or would not fit into memory.
  TWINEDGE_STATUS_LENGTH,
  // The cells of a column are not aligned, or its stride is no multiple of their size.
  TWINEDGE_STATUS_ALIGNMENT,
  // Columns are of different types.
  TWINEDGE_STATUS_TYPE,
  // A column that is needed is missing.
  TWINEDGE_STATUS_MISSING,
  // Two settings contradict each other, or a record is given twice.
  TWINEDGE_STATUS_CONFLICT,
  // There is not enough memory, or there are more than 4,294,967,294 records of a kind.
  TWINEDGE_STATUS_MEMORY,
  // A defect of this library: it panicked, and the message went to the standard error. Or a callback in Rust that panicked. (An
  // exception of C++ that leaves a callback is no error of this kind: it ends the process.)
  TWINEDGE_STATUS_PANIC,
} twinedge_status;

// A kind of record.
typedef enum {
  // Vertices.
  TWINEDGE_RECORD_VERTEX,
  // Half-edges.
  TWINEDGE_RECORD_HALF_EDGE,
  // Boundary components: CGAL's CCBs.
  TWINEDGE_RECORD_BOUNDARY,
  // Faces.
  TWINEDGE_RECORD_FACE,
} twinedge_record;

// A link: what a column holds.
typedef enum {
  // Per half-edge: the vertex where it starts. This or `TARGET` is needed.
  TWINEDGE_LINK_ORIGIN,
  // Per half-edge: the vertex where it ends. Reports then speak of origins that follow: that of a half-edge is the target of its twin.
  TWINEDGE_LINK_TARGET,
  // Per half-edge: the other half-edge of its edge. Without this column, the twin of half-edge `h` is `h ^ 1`, and the text of a report
  // says so. A structure of pointers needs it.
  TWINEDGE_LINK_TWIN,
  // Per half-edge: the one that follows on its cycle. Needed.
  TWINEDGE_LINK_NEXT,
  // Per half-edge: the one that precedes.
  TWINEDGE_LINK_PREV,
  // Per half-edge: the face to its left, in structures without records of boundary components. Each face has one cycle then, the
  // outside too. A map in the plane with several components, or with faces that have holes, needs `BOUNDARY` instead. Where the
  // outside has no record, its half-edges have the face nil: expect `OPEN`, also with `PLANE`.
  TWINEDGE_LINK_FACE,
  // Per half-edge: its boundary component. Needs the links of boundary components, `OUTER`, `INNER_FIRST` and `INNER`.
  TWINEDGE_LINK_BOUNDARY,
  // Per vertex: a half-edge that leaves it.
  TWINEDGE_LINK_LEAVING,
  // Per vertex: the boundary component that it is, if it is isolated.
  TWINEDGE_LINK_ISOLATED,
  // Per face: a half-edge of it, in structures without records of boundary components. Every face needs one, the outside of a plane
  // too, if it has a record: nil is for no face. Needs `FACE`.
  TWINEDGE_LINK_FACE_HALF_EDGE,
  // Per face: its outer boundary component; nil for the unbounded face.
  TWINEDGE_LINK_OUTER,
  // Per face, and one more: where its list begins in `INNER`. It ends where that of the next face begins.
  TWINEDGE_LINK_INNER_FIRST,
  // The inner boundary components of all faces, one list after the other.
  TWINEDGE_LINK_INNER,
  // Per boundary component: the face that it bounds.
  TWINEDGE_LINK_BOUNDARY_FACE,
  // Per boundary component: a half-edge of it; nil if it is an isolated vertex.
  TWINEDGE_LINK_BOUNDARY_HALF_EDGE,
  // Per boundary component: the isolated vertex that it is. Read where it has no half-edge.
  TWINEDGE_LINK_BOUNDARY_VERTEX,
} twinedge_link;

// A claim about a structure, beyond the rules that every structure keeps.
typedef enum {
  // Not 0: it lies in the plane: every component has genus 0 (T3). With `BOUNDARY`, faces and components nest (F1, T1, T2): then the
  // one unbounded face has `OUTER` nil. With `FACE`, no face is unbounded: each keeps a half-edge. Otherwise it is a surface of any genus.
  TWINEDGE_EXPECTED_PLANE,
  // Not 0: borders are legal, where a half-edge lacks its twin or its face.
  TWINEDGE_EXPECTED_OPEN,
  // Not 0: there are no loops and no parallel edges (M2).
  TWINEDGE_EXPECTED_SIMPLE,
  // Not 0: there is no border (M4).
  TWINEDGE_EXPECTED_CLOSED,
  // Not 0: a half-edge leaves every vertex (M1).
  TWINEDGE_EXPECTED_USED,
  // Not 0: a border vertex keeps a border half-edge (M8).
  TWINEDGE_EXPECTED_BORDER_KEPT,
  // Every bounded face has so many sides (M3).
  TWINEDGE_EXPECTED_SIDES,
  // There are so many components with an edge (M5). `twinedge_count` counts isolated vertices as components, too.
  TWINEDGE_EXPECTED_COMPONENTS,
  // There are so many border loops (M6).
  TWINEDGE_EXPECTED_BORDERS,
  // There are so many handles (M7).
  TWINEDGE_EXPECTED_GENUS,
  // No expectation: at most so many violations are listed. All are counted. 1000 if this is not set.
  TWINEDGE_EXPECTED_LIST,
} twinedge_expected;

// A number that a report counts.
typedef enum {
  // Vertices.
  TWINEDGE_COUNT_VERTICES,
  // Half-edges.
  TWINEDGE_COUNT_HALF_EDGES,
  // Edges: pairs of twins, and half-edges without twin.
  TWINEDGE_COUNT_EDGES,
  // Faces.
  TWINEDGE_COUNT_FACES,
  // Boundary components that faces list as outer.
  TWINEDGE_COUNT_OUTER_BOUNDARIES,
  // Boundary components that faces list as inner, isolated vertices included.
  TWINEDGE_COUNT_INNER_BOUNDARIES,
  // Vertices that no half-edge leaves.
  TWINEDGE_COUNT_ISOLATED_VERTICES,
  // Connected components. An isolated vertex is one.
  TWINEDGE_COUNT_COMPONENTS,
  // Cycles of `next` that are no border loops.
  TWINEDGE_COUNT_CYCLES,
  // Border loops.
  TWINEDGE_COUNT_BORDERS,
  // The sum of the genera of the components.
  TWINEDGE_COUNT_GENUS,
  // Violations, listed or not.
  TWINEDGE_COUNT_VIOLATIONS,
} twinedge_count;

// The result of a validation. Strings that are read from it belong to it. Any number of threads may read it.
typedef struct twinedge_report twinedge_report;

// A half-edge structure, as the caller describes it. It holds pointers to the caller's memory, and copies nothing of it.
//
// One thread at a time may use it.
typedef struct twinedge_structure twinedge_structure;

// One violation of a report, to which it belongs.
typedef struct twinedge_violation twinedge_violation;

// A function that returns the target of a link of a record: a record, or null for nil. It gets the context and a record, and is
// called once for each record. It must not throw: that ends the process.
typedef const void *(*twinedge_link_of)(void *context, const void *record);

// The inner boundary component at this position of the list of a face, in `*inner`. False if the list has no such position. It gets
// the context, a face and the positions from 0 on. It must not throw: that ends the process.
typedef bool (*twinedge_inner_of)(void *context, const void *face, size_t position, const void **inner);

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// The version of this library.
const char *twinedge_version(void);

// A structure without columns. By default it is to be a closed surface of any genus. Free it with `twinedge_structure_free`.
//
// A setter that fails changes nothing else, but the structure stays failed: each `twinedge_validate` returns the first failure of a
// setter again, so a caller may look at its status alone. Free the structure then, and start over.
twinedge_structure *twinedge_structure_new(void);

// Frees the structure. Reports of it stay.
void twinedge_structure_free(twinedge_structure *structure);

// The message of the first setter that failed; else, of the last `twinedge_validate` if it failed; else "". It belongs to the
// structure, until the next call on it.
const char *twinedge_structure_error(const twinedge_structure *structure);

// A column of `count` links of 32 bits with sign. `stride` is the number of bytes from one link to the next: `sizeof` the struct for a
// field of an array of structs, 0 for an array of links, negative for one that is read backwards. Nil is −1. The memory is
// read by `twinedge_validate`, and must be there until then. All columns of a structure are of one type. A column that is given again
// takes the place of the first.
//
// O(1). Errors: `NULL`, `UNKNOWN` (no such link), `LENGTH`, `ALIGNMENT`, `TYPE`.
twinedge_status twinedge_column_i32(twinedge_structure *structure,
                                    int link,
                                    const int32_t *cells,
                                    size_t count,
                                    ptrdiff_t stride);

// The same of 64 bits with sign; nil is −1.
twinedge_status twinedge_column_i64(twinedge_structure *structure,
                                    int link,
                                    const int64_t *cells,
                                    size_t count,
                                    ptrdiff_t stride);

// The same of 32 bits without sign; nil is the largest number.
twinedge_status twinedge_column_u32(twinedge_structure *structure,
                                    int link,
                                    const uint32_t *cells,
                                    size_t count,
                                    ptrdiff_t stride);

// The same of 64 bits without sign; nil is the largest number.
twinedge_status twinedge_column_u64(twinedge_structure *structure,
                                    int link,
                                    const uint64_t *cells,
                                    size_t count,
                                    ptrdiff_t stride);

// Sets the number of records of a kind, for vertices, faces and boundary components that no column counts.
//
// By default there are as many vertices as `LEAVING` or `ISOLATED` has, as many faces as `FACE_HALF_EDGE` or `OUTER` has; else as many
// as `twinedge_live` has marks; else one more than the largest link, but at most as many as half-edges. Errors: `NULL`, `UNKNOWN`.
twinedge_status twinedge_records(twinedge_structure *structure,
                                 int kind,
                                 size_t count);

// Marks the live records of a kind: a byte for each, 0 for a slot that is vacant. By default all are. `stride` is the number of
// bytes from one to the next; 0 means 1.
//
// Errors: `NULL`, `UNKNOWN`, `LENGTH`.
twinedge_status twinedge_live(twinedge_structure *structure,
                              int kind,
                              const uint8_t *live,
                              size_t count,
                              ptrdiff_t stride);

// The records of a kind, for a structure of pointers: an array of `count` pointers, none of them null or there twice. Reports name a
// record by its position. A record that is not in the array is not validated, and a link to it dangles.
//
// Errors: `NULL`, `UNKNOWN`, `LENGTH`, `ALIGNMENT`; of `twinedge_validate`: `NULL`, `CONFLICT`.
twinedge_status twinedge_pointers(twinedge_structure *structure,
                                  int kind,
                                  const void *const *records,
                                  size_t count);

// The function that says where a link leads, for a structure of pointers. It is called by `twinedge_validate`, once for each record. It
// must not free the structure, and must return: an exception of C++ that leaves it ends the process, with a message that does not
// name the function. In C++, `follow` of `twinedge/twinedge.hpp` takes functions that may throw.
//
// `NEXT`, `TWIN` and one of `ORIGIN` and `TARGET` are needed, and the lists of the records that have a link and to which it leads.
//
// Errors: `NULL`, `UNKNOWN` (no such link, or one of `INNER_FIRST` and `INNER`, which are for `twinedge_follow_inner`); of
// `twinedge_validate`: `MISSING`.
twinedge_status twinedge_follow(twinedge_structure *structure,
                                int link,
                                twinedge_link_of function,
                                void *context);

// The function that says what faces list as inner boundary components, for a structure of pointers. All lists together are read up
// to twice as many as there are boundary components, and 17. The lists of faces and of boundary components are needed.
//
// Errors: `NULL`; of `twinedge_validate`: `MISSING`.
twinedge_status twinedge_follow_inner(twinedge_structure *structure,
                                      twinedge_inner_of function,
                                      void *context);

// Holds the structure to the promises of a library, instead of `PLANE`: `surface_mesh` and `arrangement_2` (CGAL), `openmesh`, `trimesh`,
// `compas`, `networkx`. All columns that are given are looked at. Errors: `NULL`, `UNKNOWN`.
twinedge_status twinedge_preset(twinedge_structure *structure,
                                const char *name);

// Something that is expected, one of `twinedge_expected`: with a number, or 1 to ask for it and 0 not to. Errors: `NULL`, `UNKNOWN`.
twinedge_status twinedge_expect(twinedge_structure *structure,
                                int what,
                                size_t number);

// Validates the structure. `*report` is the report, which the caller frees with `twinedge_report_free`, or null if there is an error.
// That a structure is not valid is no error.
//
// O(n) time and memory for n records. It returns on any links whatever. Errors: all of `twinedge_status`.
twinedge_status twinedge_validate(twinedge_structure *structure,
                                  twinedge_report **report);

// Frees the report, with its violations and strings.
void twinedge_report_free(twinedge_report *report);

// Returns true if no violation was found and every rule that applies was checked.
bool twinedge_report_valid(const twinedge_report *report);

// A number of the report, one of `twinedge_count`; `UINT64_MAX` for what could not be counted because a rule is broken, and for a
// number that names nothing.
uint64_t twinedge_report_count(const twinedge_report *report,
                               int count);

// The report as text, a line for each rule, then a line for each violation that is listed. It is for people, and may change.
const char *twinedge_report_text(const twinedge_report *report);

// The report as JSON, in the form of docs/report.md. Numbers that a double does not hold are strings.
const char *twinedge_report_json(const twinedge_report *report);

// Returns the number of violations that are listed.
size_t twinedge_report_listed(const twinedge_report *report);

// The violation at this position of the list, in the order of the rules; null past the end.
const twinedge_violation *twinedge_report_violation(const twinedge_report *report, size_t position);

// The id of the broken rule, as `L1`.
const char *twinedge_violation_rule(const twinedge_violation *violation);

// The kind of violation, one of the names in docs/report.md, as `twin_not_mutual`.
const char *twinedge_violation_kind(const twinedge_violation *violation);

// Returns a sentence that says what is wrong.
const char *twinedge_violation_message(const twinedge_violation *violation);

// Returns the usual cause of a violation of this kind.
const char *twinedge_violation_cause(const twinedge_violation *violation);

// Returns the remedy, in the words of this header.
const char *twinedge_violation_remedy(const twinedge_violation *violation);

// The record at position 0, which is at fault, or at position 1. Its kind goes to `*kind`, its index to `*index`; either may be null.
// False if there is none.
bool twinedge_violation_record(const twinedge_violation *violation,
                               size_t position,
                               int *kind,
                               size_t *index);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* TWINEDGE_H */
