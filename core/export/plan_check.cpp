#include "core/export/plan_check.h"

#include "core/base/memory.h"

#include <set>

namespace fumage {

namespace {

Result<std::vector<CheckedFile>> check(const Scene& scene, const ExportPlan& plan, const Task& task)
{
    const std::filesystem::path manifest = manifestOf(plan);
    const Result<ManifestSet> set = openManifests(manifest);
    if (!set) {
        return set.error();
    }
    Result<std::vector<CheckedFile>> checked = checkFiles(set.value(), std::nullopt, task);
    if (!checked) {
        return checked;
    }
    std::set<std::string> named;
    for (const CheckedFile& file : checked.value()) {
        named.insert(file.file);
    }
    const std::filesystem::path folder = std::filesystem::absolute(manifest).lexically_normal().parent_path();
    for (const std::filesystem::path& file : filesOf(scene, plan)) {
        const std::string name =
            std::filesystem::absolute(file).lexically_normal().lexically_relative(folder).generic_string();
        if (!named.contains(name)) {
            checked.value().push_back({name, {}, FileState::Extra});
        }
    }
    return checked;
}

} // namespace

Result<std::vector<CheckedFile>> checkExport(const Scene& scene, const ExportPlan& plan, const Task& task)
{
    return withinMemory([&] { return check(scene, plan, task); });
}

} // namespace fumage
