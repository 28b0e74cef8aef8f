#include "core/export/jobs/job_file.h"

#include "core/system/environment.h"
#include "core/base/memory.h"
#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/jobs/job_fields.h"
#include "core/export/output_name.h"
#include "core/export/shown.h"
#include "core/preset/library.h"
#include "core/preset/preset_node.h"
#include "core/preset/preset_file.h"

#include <algorithm>

namespace fumage {

namespace {

constexpr std::string_view kPreset = "preset";

/// The format of this kind that the ending of an output asks for, where it asks for one.
template <class Format, std::size_t kCount>
void takeEnding(const std::filesystem::path& output, const std::array<Format, kCount>& formats, Format& format)
{
    const std::string ending = endingOf(output);
    const auto* const found =
        std::find_if(formats.begin(), formats.end(), [&](Format each) { return fileEnding(each) == ending; });
    format = found == formats.end() ? format : *found;
}

bool isTooLarge(std::string_view json)
{
    return json.size() > kMaxJobsFileBytes
        || (json.size() > kMaxJobsBytes && bytesWithoutLongTexts(json) > kMaxJobsBytes);
}

class Reader {
public:
    Reader(std::string_view text, const std::string& place, const std::filesystem::path& folder)
        : m_text(text)
        , m_place(place)
        , m_folder(folder)
    {
    }

    Result<JobsReading> read()
    {
        if (isTooLarge(m_text)) {
            return Error{ErrorCode::TooLarge, makeMessage("a list of jobs of %1 bytes", m_text.size()), m_place,
                makeMessage("Lists have at most %1", kMaxJobsBytes)};
        }
        const Result<JsonNode> root = parseJsonOf(m_place, m_text);
        if (!root) {
            return root.error();
        }
        const Result<const JsonNode*> list = listIn(root.value());
        if (!list) {
            return list.error();
        }
        for (const JsonNode& node : list.value()->items) {
            if (Status status = readJob(node); !status) {
                return status.error();
            }
        }
        return std::move(m_reading);
    }

private:
    [[nodiscard]] Error errorAt(const JsonNode& node, ErrorCode code, Message message, Message remedy) const
    {
        return {code, std::move(message), placeInFile(m_place, placeInText(m_text, node.begin)), std::move(remedy)};
    }

    [[nodiscard]] Result<const JsonNode*> listIn(const JsonNode& root) const
    {
        const JsonNode* format = root.find("format");
        if (format == nullptr || format->string != kJobsFormat) {
            return errorAt(format == nullptr ? root : *format, ErrorCode::WrongType,
                makeMessage("this JSON is not a list of Fumage's jobs"),
                makeMessage("A list begins with \"format\": \"fumage-jobs\""));
        }
        const JsonNode* version = root.find("version");
        if (version == nullptr || version->type != JsonNode::Type::Number || !version->isWhole || version->number < 1.0
            || version->number > kJobsVersion) {
            return errorAt(version == nullptr ? root : *version, ErrorCode::WrongVersion,
                makeMessage(
                    "the version of the list is missing, or not one up to %1, which this program reads", kJobsVersion),
                makeMessage("Open it with a newer Fumage"));
        }
        const JsonNode* jobs = root.find("jobs");
        if (jobs == nullptr || jobs->type != JsonNode::Type::Array) {
            return errorAt(jobs == nullptr ? root : *jobs, ErrorCode::WrongType,
                makeMessage("%1: expected a list in brackets [ ]", "jobs"), {});
        }
        if (jobs->items.size() > kMaxJobs) {
            return errorAt(*jobs, ErrorCode::TooLarge, makeMessage("a list of %1 jobs", jobs->items.size()),
                makeMessage("Lists have at most %1", kMaxJobs));
        }
        return jobs;
    }

    Status readJob(const JsonNode& node)
    {
        if (node.type != JsonNode::Type::Object) {
            return errorAt(node, ErrorCode::WrongType, makeMessage("a job is an object in braces { }"), {});
        }
        if (Status status = checkKeys(node); !status) {
            return status;
        }
        ExportJob job;
        job.plan.project = Preset();
        for (const std::string_view key : jobKeys()) {
            const JsonNode* value = node.find(key);
            if (Status status = value == nullptr ? Status(Done{}) : readField(key, *value, m_text, job); !status) {
                return errorAt(*value, status.error().code,
                    makeMessage("%1: %2", std::string(key), status.error().message), status.error().remedy);
            }
            if (key == "format" && value == nullptr) {
                takeFormatOfOutput(job.plan);
            }
        }
        const Result<std::filesystem::path> source = placed(node, job.plan.source);
        if (!source) {
            return source.error();
        }
        job.plan.source = source.value();
        if (Status status = readPresetOf(node, job); !status) {
            return status;
        }
        if (!isNameOfFile(job.plan.output.filename())) {
            return errorAt(node, ErrorCode::WrongType,
                makeMessage("the job %1 names no file that it writes", inQuotes(job.name)),
                makeMessage("Write \"output\": \"smoke.png\""));
        }
        complete(node, job);
        if (Status status = placePaths(node, job.plan); !status) {
            return status;
        }
        m_reading.jobs.push_back(std::move(job));
        return Done{};
    }

    [[nodiscard]] Status checkKeys(const JsonNode& node) const
    {
        std::vector<std::string_view> known{kPreset};
        known.insert(known.end(), jobKeys().begin(), jobKeys().end());
        for (std::size_t i = 0; i < node.keys.size(); ++i) {
            if (std::find(known.begin(), known.end(), node.keys[i]) == known.end()) {
                const std::string_view near = nearestName(node.keys[i], known);
                return errorAt(node.items[i], ErrorCode::UnknownKey,
                    makeMessage("a job has no %1", inQuotes(node.keys[i])),
                    near.empty() ? Message() : makeMessage("Did you mean %1?", inQuotes(near)));
            }
        }
        return Done{};
    }

    /// Whether it is more than dots and spaces, which name folders or nothing.
    static bool isNameOfFile(const std::filesystem::path& name)
    {
        return name.string().find_first_not_of(". ") != std::string::npos;
    }

    /// A path of the list as it is from the working folder.
    /// @param node for the place of the error
    [[nodiscard]] Result<std::filesystem::path> placed(const JsonNode& node, const std::filesystem::path& path) const
    {
        if (path.empty() || *path.begin() != "~") {
            return path.empty() ? path : m_folder / path;
        }
        const std::filesystem::path home = userHome();
        if (home.empty()) {
            return errorAt(node, ErrorCode::FileNotFound, makeMessage("nobody says which folder ~ is"),
                makeMessage("Write the whole path"));
        }
        return home / path.lexically_relative("~");
    }

    Status placePaths(const JsonNode& node, ExportPlan& plan) const
    {
        for (std::filesystem::path* path : {&plan.output, &plan.recording.manifest}) {
            Result<std::filesystem::path> whole = placed(node, *path);
            if (!whole) {
                return whole.error();
            }
            *path = std::move(whole).value();
        }
        return Done{};
    }

    Status readPresetOf(const JsonNode& node, ExportJob& job)
    {
        const JsonNode* preset = node.find(kPreset);
        if (preset == nullptr) {
            return errorAt(node, ErrorCode::WrongType, makeMessage("the job %1 has no preset", inQuotes(job.name)),
                makeMessage("Write it as \"preset\", whole or as its name"));
        }
        const bool isName = preset->type == JsonNode::Type::String;
        const Result<PresetReading> reading = isName
            ? loadNamed(*preset, job)
            : readPreset(m_text, *preset, m_place, kMaxWarnings - std::min(kMaxWarnings, m_reading.warnings.size()));
        m_shown = reading ? shownBy(reading.value()) : Shown();
        if (!reading && isName) {
            job.refusal = reading.error();
            job.presetName = preset->string;
            return Done{};
        }
        if (!reading) {
            return reading.error();
        }
        job.preset = reading.value().preset;
        const std::vector<Message>& warnings = reading.value().warnings;
        m_reading.warnings.insert(m_reading.warnings.end(), warnings.begin(), warnings.end());
        return Done{};
    }

    /// A preset that stands elsewhere, and is not to be written over.
    [[nodiscard]] Result<PresetReading> loadNamed(const JsonNode& name, ExportJob& job) const
    {
        const Result<LibraryEntry> entry = find(name);
        if (!entry) {
            return errorAt(name, entry.error().code, entry.error().message, entry.error().remedy);
        }
        job.plan.source = job.plan.source.empty() ? entry.value().path : job.plan.source;
        return loadPreset(entry.value());
    }

    /// One of the library, or else a file from where the list's paths begin.
    [[nodiscard]] Result<LibraryEntry> find(const JsonNode& name) const
    {
        Result<LibraryEntry> entry = findPreset(name.string);
        if (entry && (entry.value().path.empty() || entry.value().path.is_absolute())) {
            return entry;
        }
        const Result<std::filesystem::path> file = placed(name, pathFrom(name.string));
        if (!file) {
            return file.error();
        }
        std::error_code missing;
        return entry || std::filesystem::exists(file.value(), missing)
            ? LibraryEntry{file.value().stem().string(), file.value()}
            : entry;
    }

    static void takeFormatOfOutput(ExportPlan& plan)
    {
        takeEnding(plan.output, kAllVideoFormats, plan.video.format);
        takeEnding(plan.output, kAllParticleFormats, plan.particles);
        takeEnding(plan.output, kAllAirFormats, plan.air);
        plan.format = formatOf(plan.output);
    }

    /// What a person may leave out.
    void complete(const JsonNode& node, ExportJob& job) const
    {
        job.name = job.name.empty() ? job.plan.output.filename().string() : job.name;
        job.plan.output = withEnding(job.plan.output, fileEnding(job.plan));
        if (node.find("frames") == nullptr) {
            job.plan.frames = framesOf(job.plan.kind, job.preset.scene.timeline, m_shown);
        }
        if (m_shown.sheet && node.find("columns") == nullptr && node.find("rows") == nullptr) {
            job.plan.flipbook.columns = m_shown.sheet->columns;
            job.plan.flipbook.rows = m_shown.sheet->rows;
        }
        if (job.plan.project) {
            job.plan.project = isPicture(job.plan.kind) ? std::optional(job.preset) : std::nullopt;
        }
    }

    std::string_view m_text;
    const std::string& m_place;
    const std::filesystem::path& m_folder;
    JobsReading m_reading;
    Shown m_shown; ///< by the picture that the last preset was read from
};

std::string formatJob(const ExportJob& job)
{
    std::string out = "    {";
    for (const std::string_view key : jobKeys()) {
        if (const std::optional<std::string> value = writtenField(key, job)) {
            out += "\n      " + quoteJson(key) + ": " + *value + ",";
        }
    }
    if (job.refusal) {
        return out + "\n      " + quoteJson(kPreset) + ": " + quoteJson(job.presetName) + "\n    }";
    }
    // As it stands in a file of its own: what this version does not know in it must not change from one writing to the
    // next.
    std::string preset = formatPreset(job.preset);
    preset.pop_back();
    return out + "\n      " + quoteJson(kPreset) + ": " + preset + "\n    }";
}

} // namespace

std::string formatJobs(std::span<const ExportJob> jobs)
{
    std::string list;
    for (const ExportJob& job : jobs) {
        list += (list.empty() ? "\n" : ",\n") + formatJob(job);
    }
    return "{\n  \"format\": " + quoteJson(kJobsFormat) + ",\n  \"version\": " + std::to_string(kJobsVersion)
        + ",\n  \"jobs\": [" + list + "\n  ]\n}\n";
}

std::string formatPlan(const ExportPlan& plan)
{
    const ExportJob job{{}, {}, plan};
    std::string out;
    for (const std::string_view key : jobKeys()) {
        if (const std::optional<std::string> value = writtenField(key, job)) {
            out += (out.empty() ? "{" : ", ") + quoteJson(key) + ": " + *value;
        }
    }
    return out + "}";
}

std::optional<ExportPlan> parsePlan(std::string_view json)
{
    const Result<JsonNode> root = parseJsonOf({}, json);
    if (!root || root.value().type != JsonNode::Type::Object) {
        return std::nullopt;
    }
    ExportJob job;
    job.plan.project = Preset();
    for (const std::string_view key : jobKeys()) {
        if (const JsonNode* value = root.value().find(key)) {
            ExportJob with = job;
            job = readField(key, *value, json, with) ? with : job;
        }
    }
    return job.plan;
}

Result<JobsReading> parseJobs(std::string_view json, const std::string& place, const std::filesystem::path& folder)
{
    return withinMemory([&]() -> Result<JobsReading> { return Reader(json, place, folder).read(); });
}

Result<JobsReading> readJobsFile(const std::filesystem::path& path)
{
    const Result<std::string> text = readFile(path, kMaxJobsFileBytes);
    // Names stay as short as they are written where the list lies in the working folder.
    const std::filesystem::path folder = path.parent_path();
    return text ? parseJobs(text.value(), path.string(), isSameFile(folder, ".") ? std::filesystem::path() : folder)
                : text.error();
}

Status writeJobsFile(const std::filesystem::path& path, std::span<const ExportJob> jobs, FileAccess access)
{
    const std::string text = formatJobs(jobs);
    if (jobs.size() > kMaxJobs || isTooLarge(text)) {
        return Error{ErrorCode::TooLarge, makeMessage("a list of %1 jobs", jobs.size()), path.string(),
            makeMessage("Lists have at most %1", kMaxJobs)};
    }
    return writeFileAtomically(path, text, access);
}

} // namespace fumage
