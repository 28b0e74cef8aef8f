#include "core/export/jobs/job_fields.h"

#include "core/base/joined.h"
#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/export_option_table.h"
#include "core/export/option_kinds.h"

#include <algorithm>
#include <array>
#include <vector>

namespace fumage {

namespace {

using Written = std::optional<std::string>;

constexpr std::size_t kMaxPathBytes = 4096;
constexpr std::size_t kMaxOptionBytes = 1000;

// --- what stands in JSON ---

Status readText(const JsonNode& value, std::size_t longest, std::string& out)
{
    if (value.type != JsonNode::Type::String) {
        return Error{ErrorCode::WrongType, makeMessage("expected a text in quotes"), {}, {}};
    }
    if (value.string.size() > longest) {
        return Error{ErrorCode::TooLarge, makeMessage("a text of %1 bytes", value.string.size()), {},
            makeMessage("Write at most %1", longest)};
    }
    // A zero byte would end the name of a file before its ending.
    if (value.string.find('\0') != std::string::npos) {
        return Error{ErrorCode::Syntax, makeMessage("there is a zero byte in the text"), {}, {}};
    }
    out = value.string;
    return Done{};
}

Status readPath(const JsonNode& value, std::filesystem::path& out)
{
    std::string text;
    if (Status status = readText(value, kMaxPathBytes, text); !status) {
        return status;
    }
    out = pathFrom(text);
    return Done{};
}

/// Reads what a function makes of a text.
template <class Parsed, class Parse>
Status readAs(const JsonNode& value, const Parse& parse, Parsed& out)
{
    std::string text;
    if (Status status = readText(value, kMaxOptionBytes, text); !status) {
        return status;
    }
    const Result<std::decay_t<decltype(parse(text).value())>> parsed = parse(text);
    if (!parsed) {
        return parsed.error();
    }
    out = parsed.value();
    return Done{};
}

/// Of enumerators that are counted from 0, the one with a name among theirs.
template <class Enum, std::size_t kCount>
Result<Enum> named(std::string_view name)
{
    if (const std::optional<Enum> found = enumeratorNamed<Enum, kCount>(name)) {
        return *found;
    }
    return unknownName(name, namesOf<Enum, kCount>());
}

/// A format that has no name but its ending.
template <class Format, std::size_t kCount>
Result<Format> formatNamed(const std::array<Format, kCount>& formats, std::string_view name)
{
    std::vector<std::string> all;
    for (const Format format : formats) {
        if (fileEnding(format).substr(1) == name) {
            return format;
        }
        all.emplace_back(fileEnding(format).substr(1));
    }
    return unknownName(name, all);
}

std::string_view formatOf(const ExportPlan& plan)
{
    return isImage(plan.kind) ? nameOf(plan.format) : fileEnding(plan).substr(1);
}

/// There is one.
Status readVolumeFormat(const JsonNode& value)
{
    constexpr std::string_view kOnly = kVdbEnding.substr(1);
    std::string name;
    if (Status status = readText(value, kMaxJobName, name); !status) {
        return status;
    }
    return name == kOnly ? Status(Done{}) : unknownName(name, {std::string(kOnly)});
}

Status readFormat(const JsonNode& value, ExportPlan& plan)
{
    switch (plan.kind) {
    case ExportKind::Video:
        return readAs(
            value, [](std::string_view name) { return formatNamed(kAllVideoFormats, name); }, plan.video.format);
    case ExportKind::Particles:
        return readAs(
            value, [](std::string_view name) { return formatNamed(kAllParticleFormats, name); }, plan.particles);
    case ExportKind::Air:
        return readAs(
            value, [](std::string_view name) { return formatNamed(kAllAirFormats, name); }, plan.air);
    case ExportKind::Volumes: return readVolumeFormat(value);
    default: return readAs(value, named<ImageFormat, kAllImageFormats.size()>, plan.format);
    }
}

// --- options of the export ---

/// The text of an option as it stands in JSON.
std::string written(const ExportOption& option, const std::string& text)
{
    switch (option.form) {
    case OptionForm::Text:
    case OptionForm::Path: return quoteJson(text);
    case OptionForm::List: {
        std::vector<std::string> quoted = splitList(text);
        std::ranges::transform(quoted, quoted.begin(), [](const std::string& each) { return quoteJson(each); });
        return "[" + joined(quoted) + "]";
    }
    case OptionForm::Whole:
    case OptionForm::Number:
    case OptionForm::Flag:
    case OptionForm::Points: break;
    }
    return text;
}

Status readList(const ExportOption& option, const JsonNode& value, ExportPlan& plan)
{
    if (value.type != JsonNode::Type::Array || value.items.size() > kMaxPackedPictures) {
        return Error{ErrorCode::WrongType,
            makeMessage("expected a list of up to %1 texts such as \"masks=shadow,alpha\"", kMaxPackedPictures), {},
            {}};
    }
    for (const JsonNode& item : value.items) {
        std::string text;
        if (Status status = readText(item, kMaxOptionBytes, text); !status) {
            return status;
        }
        if (Status status = option.read(text, plan); !status) {
            return status;
        }
    }
    return Done{};
}

/// A number as its option reads it; what is none becomes what no option takes.
std::string numberText(const ExportOption& option, const JsonNode& value, std::string_view source)
{
    constexpr double kLargestWhole = 1e9; // of any option
    const bool isWhole = value.isWhole && std::abs(value.number) <= kLargestWhole;
    if (value.type != JsonNode::Type::Number || (option.form == OptionForm::Whole && !isWhole)) {
        return "?";
    }
    return option.form == OptionForm::Whole ? std::to_string(static_cast<std::int64_t>(value.number))
                                            : std::string(source);
}

Status readOption(const ExportOption& option, const JsonNode& value, std::string_view source, ExportPlan& plan)
{
    switch (option.form) {
    case OptionForm::Text:
    case OptionForm::Path: {
        std::string text;
        const std::size_t most = option.form == OptionForm::Path ? kMaxPathBytes : kMaxOptionBytes;
        const Status status = readText(value, most, text);
        return status ? option.read(text, plan) : status;
    }
    case OptionForm::Flag:
        if (value.type != JsonNode::Type::Bool) {
            return Error{ErrorCode::WrongType, makeMessage("expected true or false"), {}, {}};
        }
        return option.read(value.flag ? "true" : "false", plan);
    case OptionForm::Whole:
    case OptionForm::Number: return option.read(numberText(option, value, source), plan);
    case OptionForm::Points: return option.read(source, plan);
    case OptionForm::List: break;
    }
    return readList(option, value, plan);
}

// --- what only a job has, or reads in a way of its own ---

struct JobField {
    std::string_view key;
    Written (*written)(const ExportJob& job);
    Status (*read)(const JsonNode& value, ExportJob& job);
};

using Json = const JsonNode&;
using From = const ExportJob&;
using To = ExportJob&;

constexpr auto kFields = std::to_array<JobField>({
    {"name", [](From job) -> Written { return quoteJson(job.name); },
        [](Json value, To job) { return readText(value, kMaxJobName, job.name); }},
    {"kind", [](From job) -> Written { return quoteJson(nameOf(job.plan.kind)); },
        [](Json value, To job) { return readAs(value, named<ExportKind, kExportKinds>, job.plan.kind); }},
    {"output", [](From job) -> Written { return quoteJson(job.plan.output.string()); },
        [](Json value, To job) { return readPath(value, job.plan.output); }},
    {"source", [](From job) { return job.plan.source.empty() ? Written() : quoteJson(job.plan.source.string()); },
        [](Json value, To job) { return readPath(value, job.plan.source); }},
    {"frames",
        [](From job) {
            return job.plan.kind == ExportKind::NoiseTexture ? Written() : quoteJson(textOf(job.plan.frames));
        },
        [](Json value, To job) { return readAs(value, parseFrameRange, job.plan.frames); }},
    {"format", [](From job) -> Written { return quoteJson(formatOf(job.plan)); },
        [](Json value, To job) { return readFormat(value, job.plan); }},
});

std::vector<std::string_view> allKeys()
{
    std::vector<std::string_view> keys;
    for (const JobField& field : kFields) {
        keys.push_back(field.key);
    }
    for (const ExportOption& option : exportOptions()) {
        keys.push_back(option.key);
    }
    return keys;
}

} // namespace

std::span<const std::string_view> jobKeys()
{
    static const std::vector<std::string_view> keys = allKeys();
    return keys;
}

std::optional<std::string> writtenField(std::string_view key, const ExportJob& job)
{
    if (const auto* field = std::ranges::find(kFields, key, &JobField::key); field != kFields.end()) {
        return field->written(job);
    }
    const ExportOption& option = exportOption(key);
    const std::optional<std::string> text = option.applies(job.plan) ? option.text(job.plan) : std::nullopt;
    return text ? Written(written(option, *text)) : std::nullopt;
}

Status readField(std::string_view key, const JsonNode& value, std::string_view text, ExportJob& job)
{
    if (const auto* field = std::ranges::find(kFields, key, &JobField::key); field != kFields.end()) {
        return field->read(value, job);
    }
    return readOption(exportOption(key), value, text.substr(value.begin, value.end - value.begin), job.plan);
}

} // namespace fumage
