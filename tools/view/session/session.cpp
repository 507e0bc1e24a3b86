#include "tools/view/session/session.h"

#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "geolloyd/errors.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {
namespace {

constexpr int status_ok = 200;
constexpr int status_bad_request = 400;
constexpr int status_conflict = 409;
constexpr int status_not_found = 404;
constexpr double seconds_between_states = 0.05;

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

SessionAnswer refusal(int status, const std::string& text) {
  return {status, dumped({{"error", text}})};
}

std::string message_of(const std::exception& error) {
  const bool is_memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  return is_memory ? out_of_memory_message() : error.what();
}

}  // namespace

Session::Session(SessionModel& model, std::function<void()> on_change)
    : model_(model), on_change_(std::move(on_change)) {
  publish();
  thread_ = std::thread([this] { work(); });
}

Session::~Session() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  has_job_.notify_all();
  thread_.join();
}

void Session::command(std::string_view text, AnswerCallback done) {
  Job job;
  try {
    job.command = parse_command(text);
  } catch (const InvalidInput& error) {
    done(refusal(status_bad_request, error.what()));
    return;
  }
  job.is_command = true;
  job.done = std::move(done);
  add_job(std::move(job));
}

void Session::bundle(std::string_view name, AnswerCallback done) {
  Job job;
  job.bundle = name;
  job.done = std::move(done);
  add_job(std::move(job));
}

void Session::add_job(Job job) {
  {
    const std::lock_guard lock(mutex_);
    if (job.is_command) ++commands_waiting_;
    jobs_.push_back(std::move(job));
  }
  has_job_.notify_all();
}

std::string Session::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

void Session::work() {
  while (!is_ending_) {
    Job job;
    if (take_job(job)) {
      do_job(job);
    } else if (is_running_) {
      run_on();
    } else {
      wait_for_jobs();
    }
  }
}

void Session::wait_for_jobs() {
  std::unique_lock lock(mutex_);
  has_job_.wait(lock, [this] { return is_ending_ || !jobs_.empty(); });
}

bool Session::take_job(Job& job) {
  const std::lock_guard lock(mutex_);
  if (jobs_.empty()) return false;
  job = std::move(jobs_.front());
  jobs_.pop_front();
  if (job.is_command) --commands_waiting_;
  return true;
}

void Session::do_job(Job& job) {
  if (job.is_command) {
    do_command(job);
  } else {
    answer_bundle(job);
  }
}

void Session::answer_bundle(const Job& job) {
  try {
    job.done({status_ok, model_.bundle(job.bundle)});
  } catch (const InvalidInput& error) {
    job.done(refusal(status_not_found, error.what()));
  } catch (const std::bad_alloc& error) {
    job.done(refusal(status_conflict, message_of(error)));
  }
}

SessionAnswer Session::accepted() {
  return {status_ok, dumped({{"revision", model_.revision()}})};
}

void Session::do_command(Job& job) {
  const Action action = job.command.action;
  if (action == Action::remesh) {
    do_remesh(job);
    return;
  }
  is_running_ = false;
  task_ = {{"name", name_of(action_names, action)}, {"text", text_of(action)}};
  const bool takes_long = action == Action::set || action == Action::choose_seeds ||
                          action == Action::truth || action == Action::dual ||
                          action == Action::save;
  if (takes_long) publish();
  std::optional<SessionAnswer> answer;
  try {
    model_.perform(job.command, [this] { return !is_ending_; });
    is_running_ = action == Action::run && !model_.is_done();
  } catch (const std::exception& error) {
    fail(error);
    answer = refusal(status_conflict, message_of(error));
  }
  task_ = nullptr;
  publish();
  job.done(answer ? *answer : accepted());
}

// What is asked meanwhile is answered from within.
void Session::do_remesh(Job& job) {
  is_running_ = is_stopped_ = false;
  task_ = {{"name", "remesh"}, {"text", text_of(Action::remesh)}};
  publish();
  job.done(accepted());
  try {
    model_.perform(job.command, [this] {
      serve_meanwhile();
      return !is_stopped_ && !is_ending_;
    });
  } catch (const std::exception& error) {
    fail(error);
  }
  task_ = nullptr;
  publish();
}

void Session::serve_meanwhile() {
  if (since_published_.seconds() >= seconds_between_states) publish();
  for (Job job; take_job(job);) {
    if (!job.is_command) {
      answer_bundle(job);
    } else if (job.command.action == Action::stop || job.command.action == Action::pause) {
      is_stopped_ = true;
      job.done(accepted());
    } else {
      job.done(refusal(status_conflict, "a remesh is being made: wait, or stop it"));
    }
  }
}

void Session::run_on() {
  try {
    const bool was_taken =
        model_.take_step([this] { return !is_ending_ && commands_waiting_ == 0; });
    if (was_taken && model_.is_done()) is_running_ = false;
  } catch (const std::exception& error) {
    is_running_ = false;
    fail(error);
  }
  if (!is_running_ || since_published_.seconds() >= seconds_between_states) publish();
}

void Session::fail(const std::exception& error) {
  model_.set_message("error", message_of(error));
}

void Session::publish() {
  since_published_ = Stopwatch();
  is_busy_ = is_running_ || !task_.is_null();
  std::string text;
  try {
    text = dumped(model_.state(task_, is_running_));
  } catch (const std::bad_alloc&) {
    return;  // the earlier state stays
  }
  {
    const std::lock_guard lock(mutex_);
    state_ = std::move(text);
  }
  on_change_();
}

}  // namespace geolloyd
