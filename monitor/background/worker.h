#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <exception>
#include <iostream>
#include <utility>

namespace galilean::monitor {

/// One thread for what may block: the disk, DDS writes, checking. One job after another; what a job
/// throws is told on stderr, and its `then` is not called.
class Worker {
 public:
  explicit Worker(boost::asio::io_context& io) : io_(io) {}
  ~Worker() { finish(); }

  /// Waits until all jobs are done: before what they use goes.
  void finish() { pool_.join(); }

  template <class Job>
  void run(Job job) {
    boost::asio::post(pool_, [job = std::move(job)]() mutable { guarded(job); });
  }
  /// Hands what `job` returns to `then`, on the io_context's thread.
  template <class Job, class Then>
  void run(Job job, Then then) {
    run([this, job = std::move(job), then = std::move(then)]() mutable {
      boost::asio::post(
          io_, [then = std::move(then), result = job()]() mutable { then(std::move(result)); });
    });
  }

 private:
  static void guarded(auto& job) {
    try {
      job();
    } catch (const std::exception& error) {
      std::clog << "galilean-monitor: " << error.what() << std::endl;
    }
  }

  boost::asio::io_context& io_;
  boost::asio::thread_pool pool_{1};
};

}  // namespace galilean::monitor
