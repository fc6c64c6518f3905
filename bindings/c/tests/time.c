// The least time of a validation over columns, in milliseconds, of the torus of rust_view.rs.
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <twinedge.h>

enum { N = 500 };
static uint32_t origin[4 * N * N], twin[4 * N * N], next[4 * N * N], prev[4 * N * N], face[4 * N * N], leaving[N * N], kept[N * N];

static uint32_t vertex(uint32_t x, uint32_t y) { return y % N * N + x % N; }

int main(void) {
  for (uint32_t y = 0; y < N; y++)
    for (uint32_t x = 0; x < N; x++) {
      const uint32_t here = vertex(x, y), right = vertex(x + 1, y), above = vertex(x, y + 1);
      const uint32_t sides[] = {4 * here, 4 * right + 2, 4 * above + 1, 4 * here + 3};
      const uint32_t origins[] = {here, right, vertex(x + 1, y + 1), above};
      for (int i = 0; i < 4; i++) {
        origin[sides[i]] = origins[i];
        twin[sides[i]] = sides[i] ^ 1;
        next[sides[i]] = sides[(i + 1) % 4];
        prev[sides[i]] = sides[(i + 3) % 4];
        face[sides[i]] = here;
      }
      leaving[here] = kept[here] = 4 * here;
    }
  twinedge_structure *s = twinedge_structure_new();
  twinedge_column_u32(s, TWINEDGE_LINK_ORIGIN, origin, 4 * N * N, 0);
  twinedge_column_u32(s, TWINEDGE_LINK_TWIN, twin, 4 * N * N, 0);
  twinedge_column_u32(s, TWINEDGE_LINK_NEXT, next, 4 * N * N, 0);
  twinedge_column_u32(s, TWINEDGE_LINK_PREV, prev, 4 * N * N, 0);
  twinedge_column_u32(s, TWINEDGE_LINK_FACE, face, 4 * N * N, 0);
  twinedge_column_u32(s, TWINEDGE_LINK_LEAVING, leaving, N * N, 0);
  twinedge_column_u32(s, TWINEDGE_LINK_FACE_HALF_EDGE, kept, N * N, 0);
  twinedge_expect(s, TWINEDGE_EXPECTED_GENUS, 1);
  double least = 1e9;
  for (int i = 0; i < 5; i++) {
    struct timespec start, end;
    twinedge_report *report;
    clock_gettime(CLOCK_MONOTONIC, &start);
    if (twinedge_validate(s, &report)) return fprintf(stderr, "%s\n", twinedge_structure_error(s)), 1;
    clock_gettime(CLOCK_MONOTONIC, &end);
    if (!twinedge_report_valid(report)) return fputs(twinedge_report_text(report), stderr), 1;
    twinedge_report_free(report);
    const double ms = (double)(end.tv_sec - start.tv_sec) * 1e3 + (double)(end.tv_nsec - start.tv_nsec) / 1e6;
    if (ms < least) least = ms;
  }
  printf("%f\n", least);
  twinedge_structure_free(s);
  return 0;
}
