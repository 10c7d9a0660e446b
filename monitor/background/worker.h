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

/// One thread for what may block: the disk, DDS writes, checking. One job after another; what a job
/// throws is told on stderr.
class Worker {
 public:
  explicit Worker(boost::asio::io_context& io) : io_(io) {}
  ~Worker() { finish(); }

  /// Waits until all jobs are done. Call it before the objects that the jobs use are destroyed.
  void finish() { pool_.join(); }

  /// Runs a job whose result nobody waits for.
  template <class Job>
  void run(Job job) {
    boost::asio::post(pool_, [job = std::move(job)]() mutable { guarded("a job", job); });
  }
  /// Hands what `job` returns to `then`, on the io_context's thread; where one of them throws, what
  /// that says to `otherwise`, on the same thread.
  template <class Job, class Then, class Otherwise>
  void run(Job job, Then then, Otherwise otherwise) {
    boost::asio::post(pool_, [this, job = std::move(job), then = std::move(then),
                              otherwise = std::move(otherwise)]() mutable {
      std::optional<decltype(job())> result;
      auto failure = guarded("a job", [&] { result.emplace(job()); });
      // The job, too, goes on the io_context's thread: it may be the last that holds a session.
      boost::asio::post(
          io_, [job = std::move(job), then = std::move(then), otherwise = std::move(otherwise),
                result = std::move(result), failure = std::move(failure)]() mutable {
            if (!failure) failure = guarded("a job's end", [&] { then(*std::move(result)); });
            if (failure) guarded("a job's failure", [&] { otherwise(failure->message); });
          });
    });
  }

 private:
  boost::asio::io_context& io_;
  boost::asio::thread_pool pool_{1};
};

}  // namespace galilean::monitor
