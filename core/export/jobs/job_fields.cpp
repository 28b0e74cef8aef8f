#include "core/export/jobs/job_fields.h"

#include "core/base/path.h"
#include "core/base/text.h"
#include "core/export/sheets/cell_frames.h"
#include "core/noise/texture.h"

#include <array>

namespace fumage {

namespace {

using Written = std::optional<std::string>;

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
    constexpr std::size_t kLongestPath = 4096;
    std::string text;
    if (Status status = readText(value, kLongestPath, text); !status) {
        return status;
    }
    out = pathFrom(text);
    return Done{};
}

Status readFlag(const JsonNode& value, bool& out)
{
    if (value.type != JsonNode::Type::Bool) {
        return Error{ErrorCode::WrongType, makeMessage("expected true or false"), {}, {}};
    }
    out = value.flag;
    return Done{};
}

Status readWhole(const JsonNode& value, int low, int high, int& out)
{
    if (value.type != JsonNode::Type::Number || !value.isWhole || value.number < low || value.number > high) {
        return Error{ErrorCode::OutOfRange, makeMessage("expected a whole number from %1 to %2", low, high), {}, {}};
    }
    out = static_cast<int>(value.number);
    return Done{};
}

/// Reads what a function makes of a text.
template <class Parsed, class Parse>
Status readAs(const JsonNode& value, const Parse& parse, Parsed& out)
{
    constexpr std::size_t kLongest = 1000;
    std::string text;
    if (Status status = readText(value, kLongest, text); !status) {
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
    std::string all;
    for (std::size_t i = 0; i < kCount; ++i) {
        all += (i == 0 ? "" : ", ") + std::string(nameOf(static_cast<Enum>(i)));
    }
    return Error{ErrorCode::UnknownName, makeMessage("%1 is not known here", inQuotes(name)), {},
        makeMessage("Choose from %1", all)};
}

/// A format that has no name but its ending.
template <class Format, std::size_t kCount>
Result<Format> formatNamed(const std::array<Format, kCount>& formats, std::string_view name)
{
    std::string all;
    for (const Format format : formats) {
        if (fileEnding(format).substr(1) == name) {
            return format;
        }
        all += (all.empty() ? "" : ", ") + std::string(fileEnding(format).substr(1));
    }
    return Error{ErrorCode::UnknownName, makeMessage("%1 is not known here", inQuotes(name)), {},
        makeMessage("Choose from %1", all)};
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
    return name == kOnly ? Status(Done{})
                         : Error{ErrorCode::UnknownName, makeMessage("%1 is not known here", inQuotes(name)), {},
                             makeMessage("Choose from %1", std::string(kOnly))};
}

Status readFormat(const JsonNode& value, ExportPlan& plan)
{
    switch (plan.kind) {
    case ExportKind::Video:
        return readAs(
            value, [](std::string_view name) { return formatNamed(kAllVideoFormats, name); }, plan.video);
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

// --- who asks for what ---

Written jsonText(std::string_view text)
{
    return quoteJson(text);
}

Written flagIf(bool asked, bool flag)
{
    return asked ? Written(flag ? "true" : "false") : std::nullopt;
}

bool isFlipbook(const ExportJob& job)
{
    return job.plan.kind == ExportKind::Flipbook;
}

bool isNoise(const ExportJob& job)
{
    return job.plan.kind == ExportKind::NoiseTexture;
}

bool isVolume(const ExportJob& job)
{
    return job.plan.kind == ExportKind::Volumes;
}

bool isVideo(const ExportJob& job)
{
    return job.plan.kind == ExportKind::Video;
}

/// Whether its files are frames as pictures.
bool isOfFrames(const ExportJob& job)
{
    return job.plan.kind == ExportKind::Sequence || job.plan.kind == ExportKind::Picture;
}

/// Whether there may be others than the colour.
bool hasPasses(const ExportJob& job)
{
    return isFlipbook(job) || isOfFrames(job);
}

Status readPacks(const JsonNode& value, ExportPlan& plan)
{
    if (value.type != JsonNode::Type::Array || value.items.size() > kMaxPackedPictures) {
        return Error{ErrorCode::WrongType,
            makeMessage("expected a list of up to %1 texts such as \"masks=shadow,alpha\"", kMaxPackedPictures), {},
            {}};
    }
    for (const JsonNode& item : value.items) {
        plan.packs.emplace_back();
        if (Status status = readAs(item, parsePack, plan.packs.back()); !status) {
            return status;
        }
    }
    return Done{};
}

std::string writtenPacks(const ExportPlan& plan)
{
    std::string list;
    for (const PackedPicture& pack : plan.packs) {
        list += (list.empty() ? "" : ", ") + quoteJson(textOf(pack));
    }
    return "[" + list + "]";
}

Status readRetime(const JsonNode& value, std::string_view text, ExportPlan& plan)
{
    const Result<Curve> curve = parseRetime(text.substr(value.begin, value.end - value.begin));
    if (!curve) {
        return curve.error();
    }
    plan.retime = curve.value();
    return Done{};
}

Status readEngine(const JsonNode& value, ExportPlan& plan)
{
    if (Status status = readAs(value, named<Engine, kEngines>, plan.engine); !status) {
        return status;
    }
    plan.passes = passesFor(plan.engine);
    plan.style = styleFor(plan.engine, plan.format);
    return Done{};
}

Status readCarries(const JsonNode& value, ExportPlan& plan)
{
    bool carries = true;
    if (Status status = readFlag(value, carries); !status) {
        return status;
    }
    plan.project = carries ? std::optional(Preset()) : std::nullopt;
    return Done{};
}

Status readUp(const JsonNode& value, ExportPlan& plan)
{
    UpAxis up = UpAxis::Y;
    Status status = readAs(value, named<UpAxis, kAllUpAxes.size()>, up);
    plan.up = status ? std::optional(up) : plan.up;
    return status;
}

Status readRate(const JsonNode& value, ExportPlan& plan)
{
    FrameRate rate;
    Status status = readAs(value, parseFrameRate, rate);
    plan.rate = status ? std::optional(rate) : plan.rate;
    return status;
}

Status readVoxel(const JsonNode& value, ExportPlan& plan)
{
    if (value.type != JsonNode::Type::Number || value.number < static_cast<double>(kMinVoxel)
        || value.number > static_cast<double>(kMaxVoxel)) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("expected a number from %1 to %2", formatFloat(kMinVoxel), formatFloat(kMaxVoxel)), {}, {}};
    }
    plan.voxel = static_cast<float>(value.number);
    return Done{};
}

Status readDepth(const JsonNode& value, ExportPlan& plan)
{
    if (value.type != JsonNode::Type::Number || value.number < 0.0 || value.number > 1.0) {
        return Error{ErrorCode::OutOfRange, makeMessage("expected a number from 0 to 1"), {}, {}};
    }
    plan.noiseDepth = static_cast<float>(value.number);
    return Done{};
}

Status readAlpha(const JsonNode& value, ExportPlan& plan)
{
    std::string alpha;
    if (Status status = readText(value, kMaxJobName, alpha); !status) {
        return status;
    }
    if (alpha != "straight" && alpha != "premultiplied") {
        return Error{ErrorCode::UnknownName, makeMessage("%1 is not known here", inQuotes(alpha)), {},
            makeMessage("Choose from %1", "straight, premultiplied")};
    }
    plan.style.premultiplied = alpha == "premultiplied";
    return Done{};
}

using Json = const JsonNode&;
using Text = std::string_view;
using From = const ExportJob&;
using To = ExportJob&;

constexpr JobField kFields[] = {
    {"name", [](From job) { return jsonText(job.name); },
        [](Json value, Text, To job) { return readText(value, kMaxJobName, job.name); }},
    {"kind", [](From job) { return jsonText(nameOf(job.plan.kind)); },
        [](Json value, Text, To job) { return readAs(value, named<ExportKind, kExportKinds>, job.plan.kind); }},
    {"output", [](From job) { return jsonText(job.plan.output.string()); },
        [](Json value, Text, To job) { return readPath(value, job.plan.output); }},
    {"source", [](From job) { return job.plan.source.empty() ? Written() : jsonText(job.plan.source.string()); },
        [](Json value, Text, To job) { return readPath(value, job.plan.source); }},
    {"frames", [](From job) { return isNoise(job) ? Written() : jsonText(textOf(job.plan.frames)); },
        [](Json value, Text, To job) { return readAs(value, parseFrameRange, job.plan.frames); }},
    {"format", [](From job) { return jsonText(formatOf(job.plan)); },
        [](Json value, Text, To job) { return readFormat(value, job.plan); }},
    {"frame_rate",
        [](From job) { return isVideo(job) && job.plan.rate ? jsonText(textOf(*job.plan.rate)) : Written(); },
        [](Json value, Text, To job) { return readRate(value, job.plan); }},
    {"repeat", [](From job) { return isVideo(job) ? jsonText(nameOf(job.plan.repeat)) : Written(); },
        [](Json value, Text, To job) { return readAs(value, named<Repeat, kRepeats>, job.plan.repeat); }},
    {"columns", [](From job) { return isFlipbook(job) ? Written(std::to_string(job.plan.columns)) : Written(); },
        [](Json value, Text, To job) { return readWhole(value, 1, kMaxSheetCells, job.plan.columns); }},
    {"rows", [](From job) { return isFlipbook(job) ? Written(std::to_string(job.plan.rows)) : Written(); },
        [](Json value, Text, To job) { return readWhole(value, 1, kMaxSheetCells, job.plan.rows); }},
    {"engine", [](From job) { return isFlipbook(job) ? jsonText(nameOf(job.plan.engine)) : Written(); },
        [](Json value, Text, To job) { return readEngine(value, job.plan); }},
    {"passes", [](From job) { return hasPasses(job) ? jsonText(textOf(job.plan.passes)) : Written(); },
        [](Json value, Text, To job) { return readAs(value, parsePasses, job.plan.passes); }},
    {"layout", [](From job) { return isFlipbook(job) ? jsonText(nameOf(job.plan.style.layout)) : Written(); },
        [](Json value, Text, To job) {
            return readAs(value, named<SixWayLayout, kSixWayLayouts>, job.plan.style.layout);
        }},
    {"vectors", [](From job) { return isFlipbook(job) ? jsonText(nameOf(job.plan.style.vectors)) : Written(); },
        [](Json value, Text, To job) {
            return readAs(value, named<VectorSigns, kVectorSigns>, job.plan.style.vectors);
        }},
    {"normals", [](From job) { return isFlipbook(job) ? jsonText(nameOf(job.plan.style.normals)) : Written(); },
        [](Json value, Text, To job) {
            return readAs(value, named<NormalGreen, kNormalGreens>, job.plan.style.normals);
        }},
    {"alpha",
        [](From job) {
            return hasPasses(job) ? jsonText(job.plan.style.premultiplied ? "premultiplied" : "straight") : Written();
        },
        [](Json value, Text, To job) { return readAlpha(value, job.plan); }},
    {"packs", [](From job) { return isFlipbook(job) ? Written(writtenPacks(job.plan)) : Written(); },
        [](Json value, Text, To job) { return readPacks(value, job.plan); }},
    {"trim", [](From job) { return flagIf(isFlipbook(job), job.plan.trim); },
        [](Json value, Text, To job) { return readFlag(value, job.plan.trim); }},
    {"retime",
        [](From job) {
            return isFlipbook(job) && job.plan.retime ? Written(textOfRetime(*job.plan.retime)) : Written();
        },
        [](Json value, Text text, To job) { return readRetime(value, text, job.plan); }},
    {"power_of_two", [](From job) { return flagIf(isFlipbook(job), job.plan.powerOfTwo); },
        [](Json value, Text, To job) { return readFlag(value, job.plan.powerOfTwo); }},
    {"fit_camera", [](From job) { return flagIf(isPicture(job.plan.kind), job.plan.fitCamera); },
        [](Json value, Text, To job) { return readFlag(value, job.plan.fitCamera); }},
    {"carries_preset", [](From job) { return flagIf(isPicture(job.plan.kind), job.plan.project.has_value()); },
        [](Json value, Text, To job) { return readCarries(value, job.plan); }},
    {"manifest",
        [](From job) {
            return manifestOf(job.plan).empty() ? Written() : jsonText(job.plan.recording.manifest.string());
        },
        [](Json value, Text, To job) { return readPath(value, job.plan.recording.manifest); }},
    {"skip_existing", [](From job) { return flagIf(isOfFrames(job), job.plan.recording.skipExisting); },
        [](Json value, Text, To job) { return readFlag(value, job.plan.recording.skipExisting); }},
    {"cells", [](From job) { return isVolume(job) ? Written(std::to_string(job.plan.cells)) : Written(); },
        [](Json value, Text, To job) { return readWhole(value, kMinVolumeCells, kMaxVolumeCells, job.plan.cells); }},
    {"voxel",
        [](From job) { return isVolume(job) && job.plan.voxel ? Written(formatFloat(*job.plan.voxel)) : Written(); },
        [](Json value, Text, To job) { return readVoxel(value, job.plan); }},
    {"up",
        [](From job) { return job.plan.up && !isPicture(job.plan.kind) ? jsonText(nameOf(*job.plan.up)) : Written(); },
        [](Json value, Text, To job) { return readUp(value, job.plan); }},
    {"noise_size", [](From job) { return isNoise(job) ? Written(std::to_string(job.plan.noiseSize)) : Written(); },
        [](Json value, Text, To job) { return readWhole(value, 0, kMaxTextureSize, job.plan.noiseSize); }},
    {"noise_depth", [](From job) { return isNoise(job) ? Written(formatFloat(job.plan.noiseDepth)) : Written(); },
        [](Json value, Text, To job) { return readDepth(value, job.plan); }},
};

} // namespace

std::span<const JobField> jobFields()
{
    return kFields;
}

} // namespace fumage
