// twinedge.h for C++17: handles that free themselves, columns that are owned, errors as exceptions. Header-only.
#pragma once
#include <deque>
#include <memory>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "../twinedge.h"

namespace twinedge {

// A report. get() is the handle for the functions of twinedge.h.
struct report : std::unique_ptr<twinedge_report, decltype(&twinedge_report_free)> {
  explicit report(twinedge_report *r) : unique_ptr(r, twinedge_report_free) {}
  bool valid() const { return twinedge_report_valid(get()); }
  std::uint64_t count(twinedge_count what) const { return twinedge_report_count(get(), what); }
  const char *text() const { return twinedge_report_text(get()); }
  const char *json() const { return twinedge_report_json(get()); }
};

// A structure that owns its columns. A setter that fails makes validate() throw.
class structure {
 public:
  structure() : handle_(twinedge_structure_new(), twinedge_structure_free) {}
  structure &column(twinedge_link link, std::vector<std::uint32_t> cells) {
    columns_.push_back(std::move(cells));
    twinedge_column_u32(get(), link, columns_.back().data(), columns_.back().size(), 0);
    return *this;
  }
  structure &live(twinedge_record kind, std::vector<std::uint8_t> marks) {
    marks_.push_back(std::move(marks));
    twinedge_live(get(), kind, marks_.back().data(), marks_.back().size(), 0);
    return *this;
  }
  structure &preset(const char *name) { return twinedge_preset(get(), name), *this; }
  structure &expect(twinedge_expected what, std::size_t n = 1) { return twinedge_expect(get(), what, n), *this; }
  report validate() {
    twinedge_report *made = nullptr;
    if (twinedge_validate(get(), &made) != TWINEDGE_STATUS_OK) throw std::runtime_error(twinedge_structure_error(get()));
    return report(made);
  }
  twinedge_structure *get() const { return handle_.get(); }

 private:
  std::unique_ptr<twinedge_structure, decltype(&twinedge_structure_free)> handle_;
  std::deque<std::vector<std::uint32_t>> columns_;
  std::deque<std::vector<std::uint8_t>> marks_;
};

}  // namespace twinedge
