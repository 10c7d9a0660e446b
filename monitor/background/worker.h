// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/resource.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <list>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "core/result.h"
#include "monitor/background/guarded.h"

namespace galilean::monitor {

/// Threads for jobs that may block: disk access, DDS writes, checking of programs. One thread,
/// unless more are asked for, takes one job after another. An exception from a job is written to
/// stderr, and the next job runs. A job and what follows it are destroyed on the io_context's
/// thread, also where the job throws, because they may be a session's last owners.
class Worker {
 public:
  /// The queue of jobs that only the monitor itself makes is not bounded.
  static constexpr std::size_t kUnbounded = std::numeric_limits<std::size_t>::max();

  /// Whether the processor runs other threads first where it is short.
  enum class Priority { kNormal, kLow };

  explicit Worker(boost::asio::io_context& io, std::size_t threads = 1,
                  std::size_t most_waiting = kUnbounded, Priority priority = Priority::kNormal)
      : io_(io), most_waiting_(most_waiting), priority_(priority), pool_(threads) {}
  ~Worker() { finish(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Waits until all jobs are done. No job runs after that. Call it before the objects that the
  /// jobs use are destroyed.
  void finish() { pool_.join(); }
  /// Drops the jobs that have not begun, without a word to who waits for them. Call it before
  /// `finish` where those jobs would take long.
  void drop_waiting() noexcept { drops_ = true; }

  /// Runs a job that has no result, however many wait.
  template <class Job>
  void run(Job job) {
    const auto nothing = [](const auto&) {};
    run(
        [job = std::move(job)]() mutable {
          job();
          return true;
        },
        nothing, nothing);
  }
  /// Runs `job`, however many wait, then calls `then` with its result on the io_context's thread.
  /// If one of the two throws, calls `otherwise` with the exception's message on that thread.
  template <class Job, class Then, class Otherwise>
  void run(Job job, Then then, Otherwise otherwise) {
    using Whole = JobAndEnd<Job, Then, Otherwise>;
    begin(std::make_unique<Whole>(std::move(job), std::move(then), std::move(otherwise)), others_);
  }
  /// As `run`, before all jobs that wait and were not given so. For what somebody waits for who
  /// must not wait for others.
  template <class Job, class Then, class Otherwise>
  void run_first(Job job, Then then, Otherwise otherwise) {
    using Whole = JobAndEnd<Job, Then, Otherwise>;
    begin(std::make_unique<Whole>(std::move(job), std::move(then), std::move(otherwise)), first_);
  }
  /// As `run`, unless as many jobs wait as may: then does nothing and returns false. For jobs that
  /// clients ask for.
  template <class Job, class Then, class Otherwise>
  [[nodiscard]] bool offer(Job job, Then then, Otherwise otherwise) {
    if (waiting_ >= most_waiting_) return false;
    run(std::move(job), std::move(then), std::move(otherwise));
    return true;
  }
  /// Returns how many jobs have not begun.
  [[nodiscard]] std::size_t waiting() const noexcept { return waiting_; }

 private:
  struct Task {
    virtual ~Task() = default;
    virtual void work() = 0;  ///< on a thread that may block
    virtual void end() = 0;   ///< on the io_context's thread
  };
  /// In a list of one, a task goes from owner to owner without memory, which may be used up.
  using Tasks = std::list<std::unique_ptr<Task>>;

  template <class Job, class Then, class Otherwise>
  struct JobAndEnd final : Task {
    JobAndEnd(Job the_job, Then the_then, Otherwise the_otherwise)
        : job(std::move(the_job)), then(std::move(the_then)), otherwise(std::move(the_otherwise)) {}
    void work() override {
      done = guarded("a job", [this] { result.emplace(job()); });
    }
    void end() override {
      if (done) done = guarded("a job's end", [this] { then(*std::move(result)); });
      if (!done) (void)guarded("a job's failure", [this] { otherwise(done.error().message); });
    }
    Job job;
    Then then;
    Otherwise otherwise;
    std::optional<decltype(std::declval<Job&>()())> result;
    Result<void> done;
  };

  /// Puts a task among `waiting`, and has a thread take one that waits.
  void begin(std::unique_ptr<Task> task, Tasks& waiting) {
    Tasks one;
    one.push_back(std::move(task));
    const std::lock_guard lock(mutex_);
    boost::asio::post(pool_, [this] { do_one(); });  // if this throws, nothing has changed
    waiting.splice(waiting.end(), one);
    ++waiting_;
  }
  void do_one() {
    Tasks one = next();
    if (drops_) return keep_until_end(one);
    if (priority_ == Priority::kLow) lower_priority();
    one.front()->work();
    give_back(std::move(one));
  }
  [[nodiscard]] Tasks next() {
    const std::lock_guard lock(mutex_);
    Tasks& from = first_.empty() ? others_ : first_;
    Tasks one;
    one.splice(one.end(), from, from.begin());
    --waiting_;
    return one;
  }
  /// Linux has a niceness for each thread. Where it cannot be set, the thread runs as it is.
  static void lower_priority() {
    constexpr int kNiceness = 10;
    static thread_local const int kIsSet = setpriority(PRIO_PROCESS, 0, kNiceness);
    (void)kIsSet;
  }
  /// Hands a task that is done to the io_context's thread. Waits if there is no memory for that.
  void give_back(Tasks one) {
    keep_until_end(one);
    while (!post_end()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  void keep_until_end(Tasks& one) {
    const std::lock_guard lock(mutex_);
    done_.splice(done_.end(), one);
  }
  /// Returns false if there is no memory for it.
  bool post_end() {
    try {
      boost::asio::post(io_, [this] { end_one(); });
      return true;
    } catch (const std::bad_alloc&) {
      return false;
    }
  }
  void end_one() {
    Tasks one;
    {
      const std::lock_guard lock(mutex_);
      if (done_.empty()) return;
      one.splice(one.end(), done_, done_.begin());
    }
    one.front()->end();
  }

  boost::asio::io_context& io_;
  const std::size_t most_waiting_;
  const Priority priority_;
  std::atomic<std::size_t> waiting_ = 0;
  std::atomic<bool> drops_ = false;
  std::mutex mutex_;
  Tasks first_, others_;  ///< which have not begun
  Tasks done_;            ///< for the io_context's thread; what is left is destroyed with this
  boost::asio::thread_pool pool_;
};

}  // namespace galilean::monitor
