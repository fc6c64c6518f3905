// Code that the tests of the adapters share: corruptions beside another checker, and times.
#pragma once
#include <signal.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <twinedge/twinedge.hpp>

namespace trial {

inline void require(bool holds, const std::string &what) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", what.c_str());
  std::exit(1);
}

enum answer { accepts, refuses, hangs, crashes };

// Runs a checker in a child process, with so many milliseconds of processor time. An exception or a failed assertion refuses.
template <class Check>
answer in_child(Check check, int milliseconds = 20) {
  std::fflush(nullptr);
  const pid_t child = fork();
  require(child >= 0, "a process can be made");
  if (child == 0) {
    for (const int stream : {1, 2}) close(stream);
    struct itimerval limit = {};
    limit.it_value.tv_sec = milliseconds / 1000;
    limit.it_value.tv_usec = milliseconds % 1000 * 1000;
    setitimer(ITIMER_VIRTUAL, &limit, nullptr);
    int status = refuses;
    try {
      status = check() ? accepts : refuses;
    } catch (...) {
    }
    _exit(status);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status) == accepts ? accepts : refuses;
  return WTERMSIG(status) == SIGVTALRM ? hangs : WTERMSIG(status) == SIGABRT ? refuses : crashes;
}

// The outcomes of one kind of corruption.
struct row {
  const char *name;
  int all = 0, ours = 0, theirs[4] = {};

  // `broken` has been corrupted; `check` is the other checker. Every corruption breaks a rule: those that do not are not made.
  template <class Structure, class Check>
  void judge(Structure &&broken, Check check) {
    ++all;
    ours += !broken.validate().valid();
    ++theirs[in_child(check)];
  }
  row &operator+=(const row &other) {
    all += other.all, ours += other.ours;
    for (int i = 0; i < 4; ++i) theirs[i] += other.theirs[i];
    return *this;
  }
  void print() const {
    std::printf("| %s | %d | %d | %d | %d | %d | %d |\n", name, all, ours, theirs[refuses], theirs[accepts], theirs[hangs], theirs[crashes]);
  }
};

// The rows and their sum, as a table. Ours must have found all.
inline void table(const std::string &title, const std::string &checker, const std::vector<row> &rows) {
  std::printf("\n| %s | corruptions | twinedge: found | %s: found | missed | did not return | crashed |\n", title.c_str(), checker.c_str());
  std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
  row sum = {"all"};
  for (const row &each : rows) each.print(), sum += each;
  sum.print();
  require(sum.all > 100 && sum.ours == sum.all, "every corruption is found");
}

inline double milliseconds() { return 1e3 * double(std::clock()) / CLOCKS_PER_SEC; }

// Judges a sound structure twice: a row of processor times, of the second time.
template <class Of, class Check>
void healthy(const char *name, std::size_t half_edges, Of of, Check check) {
  double columns = 0, ours = 0, theirs = 0;
  for (int i = 0; i < 2; ++i) {
    const double start = milliseconds();
    auto structure = of();
    const double filled = milliseconds();
    const auto report = structure.validate();
    const double judged = milliseconds();
    require(report.valid(), std::string("a sound structure is valid\n") + report.text());
    require(report.count(TWINEDGE_COUNT_HALF_EDGES) == half_edges, "all half-edges are judged");
    const double before = milliseconds();
    require(check(), "the other checker accepts a sound structure");
    columns = filled - start, ours = judged - filled, theirs = milliseconds() - before;
  }
  std::printf("| %s | %zu | %.1f | %.1f | %.1f |\n", name, half_edges, columns, ours, theirs);
}

inline void healthy_header(const char *checker) {
  std::printf("\n| ms | half-edges | columns | validator | %s |\n| --- | --- | --- | --- | --- |\n", checker);
}

}  // namespace trial
