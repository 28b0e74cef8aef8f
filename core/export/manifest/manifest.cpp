#include "core/export/manifest/manifest.h"

#include "core/system/open_file.h"
#include "core/system/path.h"
#include "core/base/sha256.h"
#include "core/base/text.h"
#include "core/export/sequence.h"
#include "core/image_io/image_metadata.h"
#include "core/image_io/picture_pixels.h"
#include "core/preset/preset_node.h"
#include "core/preset/preset_file.h"

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

namespace fumage {

namespace {

using Json = nlohmann::ordered_json;

std::string presetText(const Scene& scene)
{
    Preset preset;
    preset.scene = scene;
    return formatPreset(preset);
}

/// Whether a path leads to somewhere within the folder that it is read in.
bool isWithin(const std::string& file)
{
    const std::filesystem::path path = pathFrom(file);
    const auto leaves = [](const std::filesystem::path& part) { return part.empty() || part == "." || part == ".."; };
    return !file.empty() && file.find('\0') == std::string::npos && !path.has_root_path()
        && std::none_of(path.begin(), path.end(), leaves);
}

class Reader {
public:
    Reader(std::string_view text, const std::string& place)
        : m_text(text)
        , m_place(place)
    {
    }

    Result<Manifest> read()
    {
        const Result<JsonNode> root = parseJsonOf(m_place, m_text);
        if (!root) {
            return root.error();
        }
        Status status = readHead(root.value());
        status = status ? readJob(root.value()) : status;
        status = status ? readFiles(root.value()) : status;
        return status ? Result<Manifest>(std::move(m_manifest)) : status.error();
    }

private:
    [[nodiscard]] Error errorAt(const JsonNode& node, ErrorCode code, Message message, Message remedy = {}) const
    {
        return {code, std::move(message), placeInFile(m_place, placeInText(m_text, node.begin)), std::move(remedy)};
    }

    /// The member of an object.
    [[nodiscard]] Result<const JsonNode*> member(const JsonNode& node, std::string_view key, JsonNode::Type type) const
    {
        const JsonNode* found = node.type == JsonNode::Type::Object ? node.find(key) : nullptr;
        if (found == nullptr || found->type != type) {
            return errorAt(found == nullptr ? node : *found, ErrorCode::WrongType,
                makeMessage("%1 is missing in the manifest, or of another type", inQuotes(key)));
        }
        return found;
    }

    Status readText(const JsonNode& node, std::string_view key, std::string& to) const
    {
        const Result<const JsonNode*> found = member(node, key, JsonNode::Type::String);
        if (!found) {
            return found.error();
        }
        to = found.value()->string;
        return Done{};
    }

    Status readHead(const JsonNode& root) const
    {
        const JsonNode* format = root.type == JsonNode::Type::Object ? root.find("format") : nullptr;
        if (format == nullptr || format->string != kManifestFormat) {
            return errorAt(root, ErrorCode::WrongType, makeMessage("this is not a manifest"),
                makeMessage("Manifests are written by --manifest"));
        }
        const Result<const JsonNode*> version = member(root, "version", JsonNode::Type::Number);
        if (!version) {
            return version.error();
        }
        if (version.value()->number != kManifestVersion) {
            return errorAt(*version.value(), ErrorCode::WrongVersion,
                makeMessage("the manifest has another version than the %1 that this program reads", kManifestVersion),
                makeMessage("Check it with the Fumage that wrote it"));
        }
        return Done{};
    }

    Status readJob(const JsonNode& root)
    {
        ManifestJob& job = m_manifest.job;
        for (const auto& [key, to] :
            {std::pair{"program", &job.program}, std::pair{"job", &m_manifest.jobHash}, std::pair{"kind", &job.kind}}) {
            if (Status status = readText(root, key, *to); !status) {
                return status;
            }
        }
        const Result<const JsonNode*> settings = member(root, "settings", JsonNode::Type::Object);
        if (!settings) {
            return settings.error();
        }
        for (const std::string& key : settings.value()->keys) {
            if (Status status = readText(*settings.value(), key, job.settings[key]); !status) {
                return status;
            }
        }
        const Result<const JsonNode*> preset = member(root, "preset", JsonNode::Type::Object);
        if (!preset) {
            return preset.error();
        }
        const Result<PresetReading> reading = readPreset(m_text, *preset.value(), m_place);
        if (!reading) {
            return reading.error();
        }
        job.scene = reading.value().preset.scene;
        return Done{};
    }

    Status readFiles(const JsonNode& root)
    {
        const Result<const JsonNode*> files = member(root, "files", JsonNode::Type::Array);
        if (!files) {
            return files.error();
        }
        for (const JsonNode& node : files.value()->items) {
            if (Status status = readEntry(node); !status) {
                return status;
            }
        }
        return Done{};
    }

    Status readEntry(const JsonNode& node)
    {
        ManifestEntry entry;
        if (Status status = readText(node, "file", entry.file); !status) {
            return status;
        }
        if (!isWithin(entry.file)) {
            return errorAt(node, ErrorCode::OutOfRange,
                makeMessage("the manifest names %1, which lies outside of its folder", inQuotes(entry.file)),
                makeMessage("Do not trust it, and have it written anew"));
        }
        entry.content.ofPixels = node.find("pixels") != nullptr;
        if (Status status = readText(node, entry.content.ofPixels ? "pixels" : "bytes", entry.content.hash); !status) {
            return status;
        }
        if (!isSha256(entry.content.hash)) {
            return errorAt(node, ErrorCode::WrongType,
                makeMessage("the manifest has %1 for a hash", inQuotes(entry.content.hash)));
        }
        if (const JsonNode* frame = node.find("frame"); frame != nullptr) {
            if (frame->type != JsonNode::Type::Number || !frame->isWhole || frame->number < 0
                || frame->number > kMaxFrame) {
                return errorAt(*frame, ErrorCode::OutOfRange,
                    makeMessage("the manifest has a frame that is no number from 0 to %1", kMaxFrame));
            }
            entry.frame = static_cast<int>(frame->number);
        }
        m_manifest.files.push_back(std::move(entry));
        return Done{};
    }

    std::string_view m_text;
    const std::string& m_place;
    Manifest m_manifest;
};

} // namespace

namespace {

/// The sum of all bytes of a file.
Result<Content> plainContentOf(const PartReader& file)
{
    constexpr std::size_t kPart = std::size_t{1} << 20U;
    Sha256 sum;
    for (std::uint64_t at = 0;;) {
        const Result<std::string> part = file(at, kPart);
        if (!part) {
            return part.error();
        }
        if (part.value().empty()) {
            return Content{false, sum.finish()};
        }
        sum.add(part.value());
        at += part.value().size();
    }
}

} // namespace

Result<Content> contentOf(std::span<const std::byte> file)
{
    return contentOf(partsOf({reinterpret_cast<const char*>(file.data()), file.size()}));
}

Result<Content> contentOfFile(const std::filesystem::path& path)
{
    const Result<OpenFile> file = OpenFile::open(path);
    return file ? contentOf([&](std::uint64_t at, std::size_t size) { return file.value().readAt(at, size); })
                : file.error();
}

Result<Content> contentOf(const PartReader& file)
{
    constexpr std::size_t kSignatureBytes = 8;
    const Result<std::string> head = file(0, kSignatureBytes);
    if (!head) {
        return head.error();
    }
    if (!isPicture(head.value())) {
        return plainContentOf(file);
    }
    Result<PictureHash> picture = pictureHash(file);
    return picture ? Result<Content>(Content{true, std::move(picture.value().hash)}) : picture.error();
}

std::string ManifestJob::hash() const
{
    Sha256 sum;
    sum.add(program + "\n" + kind + "\n");
    for (const auto& [key, value] : settings) {
        sum.add(key + "=" + value + "\n");
    }
    sum.add(presetText(scene));
    return sum.finish();
}

std::string formatManifest(const Manifest& manifest)
{
    const std::string preset = presetText(manifest.job.scene);
    Json json;
    json["format"] = kManifestFormat;
    json["version"] = kManifestVersion;
    json["program"] = manifest.job.program;
    json["job"] = manifest.jobHash;
    json["kind"] = manifest.job.kind;
    json["settings"] = manifest.job.settings;
    json["files"] = Json::array();
    for (const ManifestEntry& entry : manifest.files) {
        Json each;
        each["file"] = entry.file;
        if (entry.frame) {
            each["frame"] = *entry.frame;
        }
        each[entry.content.ofPixels ? "pixels" : "bytes"] = entry.content.hash;
        json["files"].push_back(each);
    }
    json["preset_hash"] = sha256Of(preset);
    json["preset"] = Json::parse(preset);
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Manifest> parseManifest(std::string_view json, const std::string& place)
{
    return Reader(json, place).read();
}

} // namespace fumage
