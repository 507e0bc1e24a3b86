#include "core/base/executor.h"

namespace geolloyd {
namespace {

class SequentialExecutor final : public Executor {
 public:
  SequentialExecutor() : Executor(1) {}

  void run(std::size_t workers, const std::function<void(std::size_t worker)>& work) override {
    for (std::size_t worker = 0; worker < workers; ++worker) work(worker);
  }
};

}  // namespace

Executor& sequential() {
  static SequentialExecutor executor;
  return executor;
}

}  // namespace geolloyd
