#include "tools/words/names.h"

#include "core/shapes/shapes.h"

namespace geolloyd {

const std::vector<Named<Shape>> shape_names = {
    {"creature", creature},
    {"plane", irregular_plane},
    {"icosphere", [](std::size_t triangles, std::uint64_t) { return icosphere(triangles); }},
    {"cube", [](std::size_t triangles, std::uint64_t) { return cube(triangles); }},
    {"torus", torus},
    {"cylinder", cylinder},
};

const std::vector<Named<GraphKind>> graph_kind_names = {
    {"vertex", GraphKind::vertex},     {"vertex-dense", GraphKind::vertex_dense},
    {"triangle", GraphKind::triangle}, {"triangle-dense", GraphKind::triangle_dense},
    {"mixed", GraphKind::mixed},       {"vertex-far", GraphKind::vertex_far},
};

const std::vector<Named<Norm>> norm_names = {
    {"geodesic", Norm::geodesic},
    {"manhattan", Norm::manhattan},
    {"linf", Norm::linf},
};

const std::vector<Named<Averaging>> averaging_names = {
    {"metric", Averaging::metric},
    {"pairwise", Averaging::pairwise},
};

const std::vector<Named<std::optional<Averaging>>> averaging_choice_names = {
    {"auto", std::nullopt},
    {"metric", Averaging::metric},
    {"pairwise", Averaging::pairwise},
};

const std::vector<Named<GreedyMode>> greedy_mode_names = {
    {"off", GreedyMode::off},
    {"standard", GreedyMode::standard},
    {"extended", GreedyMode::extended},
};

const std::vector<Named<std::optional<GreedyMode>>> greedy_choice_names = {
    {"auto", std::nullopt},
    {"off", GreedyMode::off},
    {"standard", GreedyMode::standard},
    {"extended", GreedyMode::extended},
};

const std::vector<Named<SeedInit>> seed_init_names = {
    {"auto", SeedInit::automatic},
    {"farthest", SeedInit::farthest},
    {"kmeans++", SeedInit::kmeans_plus_plus},
    {"random-area", SeedInit::random_area},
    {"random", SeedInit::random},
    {"surface", SeedInit::surface},
    {"coarse", SeedInit::coarse},
};

const std::vector<Named<SeedsBy>> seeds_by_names = {
    {"id", SeedsBy::id},
    {"position", SeedsBy::position},
};

const std::vector<Named<StopReason>> stop_reason_names = {
    {"converged", StopReason::converged},
    {"interrupted", StopReason::interrupted},
    {"limit", StopReason::limit},
    {"recurred", StopReason::recurred},
};

const std::vector<Named<Frontier>> frontier_names = {
    {"heap", Frontier::heap},
    {"delta", Frontier::delta},
    {"regions", Frontier::regions},
    {"auto", Frontier::automatic},
};

const std::vector<Named<Backend>> backend_names = {
    {"tbb", Backend::tbb},
    {"openmp", Backend::openmp},
};

const std::vector<Named<Phase>> phase_names = {
    {"greedy", Phase::greedy},
    {"precise", Phase::precise},
    {"improvement", Phase::improvement},
};

const std::vector<Named<RelaxOutput>> relax_output_names = {
    {"tessellation", RelaxOutput::tessellation},
    {"seeds", RelaxOutput::seeds},
    {"regions", RelaxOutput::regions},
    {"dual", RelaxOutput::dual},
    {"report", RelaxOutput::report},
};

const std::vector<Named<DualVertices>> dual_vertices_names = {
    {"seeds", DualVertices::seeds},
    {"centroids", DualVertices::centroids},
};

const std::vector<Named<double KernelSeconds::*>> kernel_names = {
    {"free_search", &KernelSeconds::free_search},
    {"locked_search", &KernelSeconds::locked_search},
    {"subtree_sums", &KernelSeconds::subtree_sums},
    {"scoring", &KernelSeconds::scoring},
    {"movement", &KernelSeconds::movement},
    {"gathering", &KernelSeconds::gathering},
    {"other", &KernelSeconds::other},
};

const std::vector<Named<EngineKind>> engine_names = {
    {"parallel", EngineKind::parallel},
    {"reference", EngineKind::reference},
};

}  // namespace geolloyd
