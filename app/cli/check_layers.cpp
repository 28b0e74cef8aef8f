#include "app/cli/check_layers.h"

#include "app/cli/progress.h"
#include "app/cli/streams.h"

#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/export/manifest/manifest_parts.h"
#include "core/export/output_name.h"
#include "core/system/path.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace fumage::cli {

namespace {

constexpr int kNameWidth = 24;
constexpr double kPercent = 100.0;
constexpr double kAlike = 45.0; ///< dB; the steps of 8 bits leave 50 and more

bool isPictureName(const std::filesystem::path& file)
{
    const std::string ending = endingOf(file);
    return ending == ".png" || ending == ".exr";
}

std::string fixed(double number, int digits)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << number;
    return text.str();
}

/// What the sheets are together, as a sentence.
std::string together(const LayeredSheets& layered, const LayeredScore& score)
{
    if (!score.decibels) {
        return "layers alone: they make no picture together";
    }
    const bool isStacked = layered.options.layers == LayerOutput::Stacked;
    return std::string(isStacked ? "drawn over one another" : "added up") + " they are the sheet of all layers to "
        + fixed(*score.decibels, 1) + " dB";
}

Status printScore(const std::string& name, const LayeredSheets& layered, const LayeredScore& score)
{
    std::ostringstream text;
    text << std::left << std::setw(kNameWidth) << "layer" << std::right << "   seen  edge alpha  empty cells  file\n";
    for (const LayerSheetScore& sheet : score.sheets) {
        text << std::left << std::setw(kNameWidth) << inQuotes(sheet.layer) << std::right << std::setw(5)
             << fixed(kPercent * sheet.seen, 1) << " %" << std::setw(12)
             << fixed(static_cast<double>(sheet.edgeAlpha), 4) << std::setw(13) << sheet.empty << "  "
             << printable(sheet.file.filename().string()) << "\n";
    }
    text << printable(name) << ": " << together(layered, score) << "\n";
    return print(text.str());
}

nlohmann::ordered_json jsonOf(const std::string& name, const LayeredSheets& layered, const LayeredScore& score)
{
    nlohmann::ordered_json json{{"sheets_of", name}, {"layers_as", std::string(nameOf(*layered.options.layers))}};
    json["decibels"] = score.decibels ? nlohmann::ordered_json(*score.decibels) : nlohmann::ordered_json();
    json["sheets"] = nlohmann::ordered_json::array();
    for (const LayerSheetScore& sheet : score.sheets) {
        json["sheets"].push_back({{"layer", sheet.layer}, {"file", sheet.file.string()}, {"seen", sheet.seen},
            {"edge_alpha", sheet.edgeAlpha}, {"empty_cells", sheet.empty}});
    }
    return json;
}

/// What somebody may want to do something about.
void warn(const LayeredSheets& layered, const LayeredScore& score)
{
    const int cells = layered.options.columns * layered.options.rows;
    for (const LayerSheetScore& sheet : score.sheets) {
        if (sheet.empty == cells) {
            report("layer " + inQuotes(sheet.layer) + " is in none of the cells");
        }
    }
    if (score.decibels && *score.decibels < kAlike) {
        report("together the sheets are not the sheet of all layers: one of them has been changed or is of another "
               "export; 'fumage-cli verify' says which");
    }
}

} // namespace

Result<std::optional<LayeredSheets>> layeredSheetsNamed(const std::string& name)
{
    const std::filesystem::path file = pathFrom(name);
    std::error_code error;
    if (!isManifest(file) && !(isPictureName(file) && std::filesystem::is_regular_file(file, error))) {
        return std::optional<LayeredSheets>();
    }
    return withinMemory([&] { return findLayeredSheets(file); });
}

Status checkLayers(const std::string& name, const LayeredSheets& layered, nlohmann::ordered_json* answer)
{
    Result<LayeredScore> score = LayeredScore();
    {
        ProgressBar bar("Measuring");
        score = withinMemory([&] { return scoreLayers(layered, bar.task()); });
    }
    if (!score) {
        return score.error();
    }
    warn(layered, score.value());
    if (answer != nullptr) {
        answer->push_back(jsonOf(name, layered, score.value()));
        return Done{};
    }
    return printScore(name, layered, score.value());
}

} // namespace fumage::cli
