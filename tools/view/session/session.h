#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "core/base/stopwatch.h"
#include "tools/view/session/session_model.h"

namespace geolloyd {

/// What a session answers: the status of HTTP, and JSON or a bundle.
struct SessionAnswer {
  int status = 200;
  std::string body;
};
using AnswerCallback = std::function<void(SessionAnswer)>;

/// A session that computes in a thread of its own, while others ask. Commands are done one after
/// the other. Each ends a run and is answered when it is done; but `run` and `remesh` are answered
/// when they begin, and while a remesh is made all commands but `stop` and `pause` are refused.
/// Bundles are made between two steps, so they always fit together.
class Session {
 public:
  /// `model` must live on, and be left alone. `on_change` is called by the session's thread.
  Session(SessionModel& model, std::function<void()> on_change);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  /// Ends what it does as soon as possible.
  ~Session();

  // From any thread. Callbacks are called once: by the session's thread, or at once by the caller.

  void command(std::string_view text, AnswerCallback done);
  void bundle(std::string_view name, AnswerCallback done);
  /// As JSON, the latest.
  [[nodiscard]] std::string state() const;
  /// It computes.
  [[nodiscard]] bool is_busy() const { return is_busy_; }

 private:
  struct Job {
    bool is_command = false;
    SessionCommand command;
    std::string bundle;
    AnswerCallback done;
  };

  void work();
  void wait_for_jobs();
  bool take_job(Job& job);
  void do_job(Job& job);
  void do_command(Job& job);
  void do_remesh(Job& job);
  void answer_bundle(const Job& job);
  void serve_meanwhile();
  void run_on();
  void add_job(Job job);
  void publish();
  void fail(const std::exception& error);
  SessionAnswer accepted();

  SessionModel& model_;
  std::function<void()> on_change_;

  mutable std::mutex mutex_;  // of the next three
  std::condition_variable has_job_;
  std::deque<Job> jobs_;
  std::string state_;

  std::atomic<bool> is_ending_ = false;
  std::atomic<bool> is_busy_ = false;
  std::atomic<int> commands_waiting_ = 0;

  // Of the thread alone.
  bool is_running_ = false;
  bool is_stopped_ = false;  // the remesh that is being made
  Json task_;
  Stopwatch since_published_;
  std::thread thread_;  // the last one: it uses all others
};

}  // namespace geolloyd
