#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace ricochet::motion {

/// Threads that wait to share a loop. Of one thread all is done by the caller.
class Workers {
 public:
  using Part = std::function<void(std::size_t first, std::size_t last)>;

  /// `threads` ≥ 1, the caller among them.
  explicit Workers(std::size_t threads);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  std::size_t threads() const noexcept { return others_.size() + 1; }
  /// Splits 0 … count−1 into as many ranges as there are threads, each but the last a multiple of `grain`, and returns
  /// when all are done. Which worker takes what is fixed. `part` must not throw.
  void share(std::size_t count, std::size_t grain, const Part& part);

 private:
  void work(std::size_t worker);
  void do_part(std::size_t worker) const;

  std::vector<std::thread> others_;
  std::atomic<unsigned> round_ = 0, busy_ = 0;
  bool over_ = false;
  std::size_t count_ = 0, grain_ = 1;
  const Part* part_ = nullptr;
};

}  // namespace ricochet::motion
