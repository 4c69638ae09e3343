#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace ricochet::motion {

/// Threads that wait for parts of one task. Of one thread all is done by the caller.
class Workers {
 public:
  using Part = std::function<void(std::size_t worker)>;

  /// `threads` ≥ 1, the caller among them.
  explicit Workers(std::size_t threads);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  std::size_t threads() const noexcept { return others_.size() + 1; }
  /// Does part(0) … part(threads() − 1) at once, 0 in the caller, each always in the same thread; returns when all are
  /// done. `part` must not throw.
  void run(const Part& part);

 private:
  void work(std::size_t worker);

  std::vector<std::thread> others_;
  std::atomic<unsigned> round_ = 0, busy_ = 0;
  bool over_ = false;
  const Part* part_ = nullptr;
};

}  // namespace ricochet::motion
