#include "core/export/sheets/sheet_note.h"

#include "core/export/manifest/recorded.h"
#include "core/preset/json_tree.h"

namespace fumage {

namespace {

constexpr const char* kName = "name";

} // namespace

std::string sheetNoteOf(const FlipbookOptions& options)
{
    std::string members;
    for (const auto& [key, value] : jobOf({}, options).settings) {
        if (key != kName) {
            members += (members.empty() ? "" : ",") + quoteJson(key) + ":" + quoteJson(value);
        }
    }
    return "{" + members + "}";
}

std::optional<FlipbookOptions> readSheetNote(const std::string& note)
{
    const Result<JsonNode> root = parseJson(note);
    if (!root || root.value().type != JsonNode::Type::Object) {
        return std::nullopt;
    }
    ManifestJob job{std::string(kFlipbookKind), {}, {}};
    for (std::size_t i = 0; i < root.value().keys.size(); ++i) {
        job.settings[root.value().keys[i]] = root.value().items[i].string;
    }
    job.settings[kName] = "sheet";
    Result<FlipbookOptions> options = flipbookOf(job);
    if (!options) {
        return std::nullopt;
    }
    options.value().output.clear();
    return std::move(options).value();
}

} // namespace fumage
