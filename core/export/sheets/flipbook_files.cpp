#include "core/export/sheets/flipbook_files.h"

#include "core/system/path.h"
#include "core/export/engines/engine_files.h"
#include "core/export/output_name.h"

#include <algorithm>
#include <iterator>

namespace fumage {

namespace {

/// The picture with a name of its own before the ending.
std::filesystem::path besides(const std::filesystem::path& picture, const std::string& name)
{
    return picture.parent_path() / pathFrom(picture.stem().string() + "_" + name + picture.extension().string());
}

} // namespace

std::vector<Pass> listOf(PassSet passes)
{
    std::vector<Pass> list;
    std::copy_if(
        kAllPasses.begin(), kAllPasses.end(), std::back_inserter(list), [&](Pass pass) { return passes.has(pass); });
    return list;
}

std::filesystem::path descriptionOf(const std::filesystem::path& picture)
{
    return std::filesystem::path(picture).replace_extension(".flipbook.json");
}

std::filesystem::path pictureOf(const std::filesystem::path& picture, Pass pass)
{
    return pass == Pass::Colour ? picture : besides(picture, fileNameOf(pass));
}

std::vector<FlipbookOptions> sheetsOf(const Scene& scene, const FlipbookOptions& options)
{
    if (!isDivided(options)) {
        return {options};
    }
    const std::filesystem::path picture = withEnding(options.output, fileEnding(options.format));
    const std::vector<WrittenLayer> layers = writtenLayers(scene);
    std::vector<FlipbookOptions> sheets;
    for (const WrittenLayer& layer : layers) {
        FlipbookOptions sheet = options;
        sheet.output = besides(picture, layer.word);
        sheet.layer = {layer.name, static_cast<int>(sheets.size()) + 1, static_cast<int>(layers.size())};
        sheets.push_back(std::move(sheet));
    }
    return sheets;
}

std::vector<std::filesystem::path> filesOf(const Scene& scene, const FlipbookOptions& options)
{
    const std::vector<FlipbookOptions> sheets = sheetsOf(scene, options);
    std::vector<std::filesystem::path> files;
    for (const FlipbookOptions& sheet : sheets) {
        std::ranges::move(filesOfSheet(sheet), std::back_inserter(files));
    }
    std::ranges::move(sharedFilesOf(options, sheets), std::back_inserter(files));
    return files;
}

std::vector<std::filesystem::path> sharedFilesOf(
    const FlipbookOptions& options, std::span<const FlipbookOptions> sheets)
{
    if (!isOfShares(options)) {
        return {};
    }
    std::vector<std::filesystem::path> pictures;
    for (const FlipbookOptions& sheet : sheets) {
        const std::vector<std::filesystem::path> drawn = picturesOf(sheet);
        if (!drawn.empty()) { // no pass: the check refuses that, after names were asked for
            pictures.push_back(drawn.front());
        }
    }
    return engineFilesOf(options.engine, withEnding(options.output, fileEnding(options.format)), pictures);
}

std::vector<std::filesystem::path> picturesOf(const FlipbookOptions& options)
{
    const std::filesystem::path picture = withEnding(options.output, fileEnding(options.format));
    std::vector<std::filesystem::path> files;
    for (const Pass pass : listOf(options.passes)) {
        files.push_back(pictureOf(picture, pass));
    }
    for (const PackedPicture& pack : options.packs) {
        files.push_back(besides(picture, pack.name));
    }
    return files;
}

std::vector<std::filesystem::path> filesOfSheet(const FlipbookOptions& options)
{
    std::vector<std::filesystem::path> files = picturesOf(options);
    if (!files.empty() && !isOfShares(options)) {
        const std::vector<std::filesystem::path> more = engineFilesOf(options.engine, files.front(), files);
        files.insert(files.end(), more.begin(), more.end());
    }
    files.push_back(descriptionOf(withEnding(options.output, fileEnding(options.format))));
    return files;
}

} // namespace fumage
