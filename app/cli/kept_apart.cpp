#include "app/cli/kept_apart.h"

#include "core/export/jobs/jobs.h"
#include "core/export/manifest/manifest_parts.h"

namespace fumage::cli {

std::vector<std::filesystem::path> pathsOf(const NumberedFiles& files)
{
    std::vector<std::filesystem::path> paths;
    for (int i = 0; i < files.frames.count(); ++i) {
        paths.push_back(framePath(files.output, files.frames, files.ending, files.frames.at(i)));
    }
    return paths;
}

Status keepApart(const std::string& preset, const Scene& scene, const ExportPlan& plan, JobFiles& written)
{
    ExportJob job{preset, {}, plan};
    job.preset.scene = scene;
    return written.add(job);
}

Status keepApart(
    const std::string& preset, const NumberedFiles& files, const std::filesystem::path& manifest, JobFiles& written)
{
    std::vector<std::filesystem::path> all = pathsOf(files);
    if (!manifest.empty()) {
        all.push_back(partOf(manifest, files.frames));
    }
    return written.add(preset, all);
}

} // namespace fumage::cli
