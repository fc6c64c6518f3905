// twinedge.h for C++17: handles that free themselves, columns that are owned, functions that may throw, errors as exceptions.
#pragma once
#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) < 201703L
#error "twinedge needs C++17"
#endif
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "../twinedge.h"

namespace twinedge {

// The reason why validate() failed: what() is the sentence.
struct error : std::runtime_error {
  twinedge_status status;
  error(twinedge_status s, const char *what) : std::runtime_error(what), status(s) {}
};

struct record {
  twinedge_record kind;
  std::size_t index;
};

// A violation of a report, which it must not outlive.
class violation {
 public:
  explicit violation(const twinedge_violation *v) : handle_(v) {}
  const char *rule() const { return twinedge_violation_rule(handle_); }
  const char *kind() const { return twinedge_violation_kind(handle_); }
  const char *message() const { return twinedge_violation_message(handle_); }
  const char *cause() const { return twinedge_violation_cause(handle_); }
  const char *remedy() const { return twinedge_violation_remedy(handle_); }
  // The record at fault, at position 0, or another one, at position 1.
  std::optional<twinedge::record> record(std::size_t position = 0) const {
    int kind = 0;
    std::size_t index = 0;
    if (!twinedge_violation_record(handle_, position, &kind, &index)) return std::nullopt;
    return twinedge::record{static_cast<twinedge_record>(kind), index};
  }

 private:
  const twinedge_violation *handle_;
};

// A report. get() is the handle for the functions of twinedge.h.
struct report : std::unique_ptr<twinedge_report, decltype(&twinedge_report_free)> {
  explicit report(twinedge_report *r) : unique_ptr(r, twinedge_report_free) {}
  bool valid() const { return twinedge_report_valid(get()); }
  std::uint64_t count(twinedge_count what) const { return twinedge_report_count(get(), what); }
  const char *text() const { return twinedge_report_text(get()); }
  const char *json() const { return twinedge_report_json(get()); }
  // Those that are listed. The report must be kept: `for (auto v : of(mesh).validate().violations())` does not compile.
  std::vector<violation> violations() const & {
    std::vector<violation> all;
    for (std::size_t i = 0; i < twinedge_report_listed(get()); ++i) all.emplace_back(twinedge_report_violation(get(), i));
    return all;
  }
  std::vector<violation> violations() && = delete;
};

// A structure that owns its columns, lists and functions. A setter that fails makes validate() throw.
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
  structure &pointers(twinedge_record kind, std::vector<const void *> records) {
    lists_.push_back(std::move(records));
    twinedge_pointers(get(), kind, lists_.back().data(), lists_.back().size());
    return *this;
  }
  // f(record) is a pointer to where the link of a `const Record &` leads, or null. What it throws, validate() throws.
  template <class Record, class F>
  structure &follow(twinedge_link link, F f) {
    auto own = std::make_shared<guarded<F>>(guarded<F>{std::move(f), thrown_});
    const auto call = [](void *context, const void *r) noexcept -> const void * {
      auto &self = *static_cast<guarded<F> *>(context);
      return self.run([&]() -> const void * { return self.function(*static_cast<const Record *>(r)); });
    };
    twinedge_follow(get(), link, call, own.get());
    functions_.push_back(std::move(own));
    return *this;
  }
  // f(face, position) is a pointer to the inner boundary component there, or null past the end of the list of a `const Face &`.
  template <class Face, class F>
  structure &follow_inner(F f) {
    auto own = std::make_shared<guarded<F>>(guarded<F>{std::move(f), thrown_});
    const auto call = [](void *context, const void *face, std::size_t position, const void **inner) noexcept {
      auto &self = *static_cast<guarded<F> *>(context);
      *inner = self.run([&]() -> const void * { return self.function(*static_cast<const Face *>(face), position); });
      return *inner != nullptr;
    };
    twinedge_follow_inner(get(), call, own.get());
    functions_.push_back(std::move(own));
    return *this;
  }
  structure &preset(const char *name) { return twinedge_preset(get(), name), *this; }
  structure &expect(twinedge_expected what, std::size_t n = 1) { return twinedge_expect(get(), what, n), *this; }
  report validate() {
    twinedge_report *made = nullptr;
    const twinedge_status status = twinedge_validate(get(), &made);
    report owned(made);
    if (*thrown_) std::rethrow_exception(std::exchange(*thrown_, nullptr));
    if (status != TWINEDGE_STATUS_OK) throw error(status, twinedge_structure_error(get()));
    return owned;
  }
  twinedge_structure *get() const { return handle_.get(); }

 private:
  // A function of which no exception leaves: the first is kept, and no function is called after it.
  template <class F>
  struct guarded {
    F function;
    std::shared_ptr<std::exception_ptr> thrown;
    template <class Run>
    const void *run(Run call) noexcept {
      if (*thrown) return nullptr;
      try {
        return call();
      } catch (...) {
        *thrown = std::current_exception();
        return nullptr;
      }
    }
  };
  std::shared_ptr<std::exception_ptr> thrown_ = std::make_shared<std::exception_ptr>();
  std::deque<std::vector<std::uint32_t>> columns_;
  std::deque<std::vector<std::uint8_t>> marks_;
  std::deque<std::vector<const void *>> lists_;
  std::vector<std::shared_ptr<void>> functions_;
  std::unique_ptr<twinedge_structure, decltype(&twinedge_structure_free)> handle_;
};

}  // namespace twinedge
