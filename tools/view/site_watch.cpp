#include "tools/view/site_watch.h"

#include <memory>
#include <utility>
#include <vector>

namespace geolloyd {
namespace {

class WatchedSurfaceEngine final : public SurfaceEngine {
 public:
  WatchedSurfaceEngine(std::unique_ptr<SurfaceEngine> engine, const SiteCallback& callback)
      : engine_(std::move(engine)), callback_(callback) {}

  void assign(std::vector<RegionId> labels, std::span<const std::uint8_t> is_fixed) override {
    engine_->assign(std::move(labels), is_fixed);
  }
  const Cells& evaluate(std::span<const Vec3> sites) override {
    const Cells& cells = engine_->evaluate(sites);
    callback_(sites);
    return cells;
  }
  [[nodiscard]] const std::vector<RegionId>& labels() const override { return engine_->labels(); }
  [[nodiscard]] const Cells& cells() const override { return engine_->cells(); }

 private:
  std::unique_ptr<SurfaceEngine> engine_;
  const SiteCallback& callback_;
};

}  // namespace

MakeSurfaceEngine watched(MakeSurfaceEngine make, SiteCallback callback) {
  const auto shared = std::make_shared<SiteCallback>(std::move(callback));
  return [make = std::move(make), shared](const FineMesh& mesh) -> std::unique_ptr<SurfaceEngine> {
    return std::make_unique<WatchedSurfaceEngine>(make(mesh), *shared);
  };
}

}  // namespace geolloyd
