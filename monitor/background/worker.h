// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <optional>
#include <string>
#include <utility>

#include "monitor/background/guarded.h"

namespace galilean::monitor {

/// One thread for jobs that may block: disk access, DDS writes, checking of programs. It runs one
/// job after another. An exception from a job is written to stderr, and the next job runs.
class Worker {
 public:
  explicit Worker(boost::asio::io_context& io) : io_(io) {}
  ~Worker() { finish(); }

  /// Waits until all jobs are done. No job runs after that. Call it before the objects that the
  /// jobs use are destroyed.
  void finish() { pool_.join(); }

  /// Runs a job that has no result.
  template <class Job>
  void run(Job job) {
    boost::asio::post(pool_, [job = std::move(job)]() mutable { (void)guarded("a job", job); });
  }
  /// Runs `job`, then calls `then` with its result on the io_context's thread. If one of the two
  /// throws, calls `otherwise` with the exception's message on the io_context's thread.
  template <class Job, class Then, class Otherwise>
  void run(Job job, Then then, Otherwise otherwise) {
    boost::asio::post(pool_, [this, job = std::move(job), then = std::move(then),
                              otherwise = std::move(otherwise)]() mutable {
      std::optional<decltype(job())> result;
      auto done = guarded("a job", [&] { result.emplace(job()); });
      // The job is destroyed on the io_context's thread, because it may be a session's last owner.
      boost::asio::post(
          io_, [job = std::move(job), then = std::move(then), otherwise = std::move(otherwise),
                result = std::move(result), done = std::move(done)]() mutable {
            if (done) done = guarded("a job's end", [&] { then(*std::move(result)); });
            if (!done) (void)guarded("a job's failure", [&] { otherwise(done.error().message); });
          });
    });
  }

 private:
  boost::asio::io_context& io_;
  boost::asio::thread_pool pool_{1};
};

}  // namespace galilean::monitor
