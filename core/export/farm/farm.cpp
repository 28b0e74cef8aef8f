#include "core/export/farm/farm.h"

#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/farm/chunk.h"
#include "core/export/templates/template_facts.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace fumage {

extern const EmbeddedFile kFarmTemplates[];
extern const std::size_t kFarmTemplatesCount;

namespace {

/// What AWS Deadline Cloud takes.
constexpr int kMaxInOpenJdChunk = 150;

using Words = std::vector<std::string>;

std::string shellQuoted(const std::string& word)
{
    return written(Language::Shell, word);
}

/// A job's name, which is only shown.
std::string shownName(const FarmJob& job)
{
    constexpr std::size_t kMaxBytes = 100; // Open Job Description takes 128 letters
    const std::string& name = job.name;
    std::size_t end = std::min(name.size(), kMaxBytes);
    while (end < name.size() && (static_cast<unsigned char>(name[end]) & 0xc0U) == 0x80U) {
        --end; // not within a letter
    }
    return name.substr(0, end);
}

/// A name that no option is mistaken for.
std::string fromHere(const std::string& name)
{
    return "./" + name;
}

Words renderWordsOf(const FarmJob& job, const std::string& frames, const std::string& folder)
{
    Words words{"render", folder + presetFileOf(job), "--frames", frames, "--output", folder + job.output,
        "--skip-existing", "--manifest"};
    words.insert(words.end(), job.renderWords.begin(), job.renderWords.end());
    return words;
}

/// The words that join the frames, with files in the folder by their whole path.
Words joinWordsIn(const std::string& folder, const FarmJob& job)
{
    Words words = job.joinWords;
    std::for_each(words.begin(), words.end(),
        [&](std::string& word) { word = word.starts_with("./") ? folder + word.substr(2) : word; });
    return words;
}

/// What a farm has no way to write in a name; empty: it can write it.
std::string_view unwritable(Farm farm, std::string_view name)
{
    std::vector<std::string_view> refused{std::string_view("\0", 1)};
    switch (farm) {
    case Farm::Slurm:
    case Farm::Flamenco: break;
    case Farm::OpenJd: refused = {"{{", "}}"}; break;
    case Farm::Deadline: refused = {"\"", "<", ">", "\\"}; break;
    }
    const auto found = std::find_if(refused.begin(), refused.end(),
        [&](std::string_view text) { return name.find(text) != std::string_view::npos; });
    if (found == refused.end() && farm == Farm::Deadline && !isOneLine(name)) {
        return "\n"; // or another of those that are not seen
    }
    return found == refused.end() ? std::string_view() : *found;
}

Status checkNames(Farm farm, const FarmJob& job)
{
    for (const std::string& name : {job.folder.generic_string(), job.name, job.output}) {
        const std::string_view found = unwritable(farm, name);
        if (!found.empty()) {
            const Message what = found == "\n" ? makeMessage("control characters") : Message(inQuotes(found));
            return Error{ErrorCode::OutOfRange,
                makeMessage("%1 has no way to write %2 in the names of files", std::string(nameOf(farm)), what),
                (job.folder / pathFrom(job.output)).string(), makeMessage("Choose another name or folder")};
        }
    }
    return Done{};
}

/// One of the farm's files.
std::filesystem::path fileOf(const FarmJob& job, std::string_view ending)
{
    return job.folder / pathFrom(job.name + std::string(ending));
}

TemplateFacts commonFacts(Language language, const FarmJob& job)
{
    TemplateFacts facts(language);
    facts.label("name", shownName(job));
    facts.number("first", job.frames.first);
    facts.number("last", job.frames.last);
    facts.number("step", job.frames.step);
    facts.flag("stepped", job.frames.step > 1);
    facts.word("frames", textOf(job.frames));
    facts.number("count", job.frames.count());
    facts.number("last_place", job.frames.count() - 1);
    facts.number("per_task", job.perTask);
    facts.number("last_task", taskCount(job.frames, job.perTask) - 1);
    facts.flag("joins", !job.joinWords.empty());
    return facts;
}

/// The words of a command line, each as "word".
template <class Describe>
void addWords(const std::string& key, const Words& words, TemplateFacts& facts, const Describe& describe)
{
    std::vector<TemplateFacts> list;
    for (const std::string& word : words) {
        list.emplace_back(facts.language());
        list.back().text("word", word);
        describe(word, list.back());
    }
    facts.list(key, std::move(list));
}

void addWords(const std::string& key, const Words& words, TemplateFacts& facts)
{
    addWords(key, words, facts, [](const std::string&, TemplateFacts&) {});
}

std::string filled(std::string_view name, const TemplateFacts& facts)
{
    const EmbeddedFile* const found = findEmbedded({kFarmTemplates, kFarmTemplatesCount}, name);
    assert(found != nullptr);
    return facts.fill(*found);
}

FarmFiles slurmFiles(const FarmJob& job)
{
    TemplateFacts facts = commonFacts(Language::Shell, job);
    facts.text("folder", job.folder.string());
    Words before = renderWordsOf(job, {}, "./");
    const auto frames = std::find(before.begin(), before.end(), "--frames") + 1;
    const Words after(frames + 1, before.end());
    before.erase(frames, before.end());
    addWords("before_frames", before, facts);
    addWords("after_frames", after, facts);
    addWords("join", job.joinWords, facts);
    const std::filesystem::path script = fileOf(job, ".slurm.sh");
    FarmFiles made{{{script, filled("slurm", facts)}}, "sbatch " + shellQuoted(script.string())};
    if (!job.joinWords.empty()) {
        const std::filesystem::path join = fileOf(job, ".join.slurm.sh");
        made.files.push_back({join, filled("slurm_join", facts)});
        made.submit = "sbatch --dependency=afterany:$(sbatch --parsable " + shellQuoted(script.string()) + ") "
            + shellQuoted(join.string());
    }
    return made;
}

FarmFiles openJdFiles(const FarmJob& job)
{
    const std::string folder = "{{Param.Folder}}/";
    TemplateFacts facts = commonFacts(Language::Json, job);
    Words words = renderWordsOf(job, "{{Task.Param.Frame}}", folder);
    words.insert(words.end(), {"--progress", "openjd"});
    addWords("render", words, facts);
    Words join = joinWordsIn(folder, job);
    if (const auto option = std::ranges::find(join, "--frames"); option != join.end()) {
        *(option + 1) = "{{Param.Frames}}"; // those that are rendered, also where other frames are asked for when the
                                            // job is submitted
    }
    addWords("join", join, facts);
    facts.number("most_per_task", kMaxInOpenJdChunk);
    const std::filesystem::path path = fileOf(job, ".openjd.json");
    return {{{path, filled("openjd", facts)}},
        "openjd run " + shellQuoted(path.string()) + " -p Folder=" + shellQuoted(job.folder.string())};
}

FarmFiles flamencoFiles(const FarmJob& job)
{
    // The frames of a task are a variable of the script, and so is the folder.
    const auto describe = [](const std::string& word, TemplateFacts& each) {
        each.flag("is_frames", word.empty());
        each.flag("in_folder", word.starts_with("./"));
        each.text("word", word.starts_with("./") ? word.substr(1) : word);
    };
    TemplateFacts facts = commonFacts(Language::JavaScript, job);
    facts.text("folder", job.folder.string());
    addWords("render", renderWordsOf(job, {}, "./"), facts, describe);
    addWords("join", job.joinWords, facts, describe);
    const std::filesystem::path path = fileOf(job, ".flamenco.js");
    return {{{path, filled("flamenco", facts)}},
        "Copy " + shellQuoted(path.string())
            + " to the folder \"scripts\" of the Flamenco Manager and choose the job type there"};
}

/// The files that Deadline reads: lines "key=value".
TemplateFacts deadlineFacts(const FarmJob& job)
{
    const auto describe = [](const std::string& word, TemplateFacts& each) {
        each.flag("quoted", word.find_first_of(" '") != std::string::npos);
    };
    const std::string folder = (job.folder / "").generic_string(); // Deadline takes a backslash for itself
    const std::string steps = job.frames.step > 1 ? ":" + std::to_string(job.frames.step) : std::string();
    TemplateFacts facts = commonFacts(Language::KeyValue, job);
    facts.text("start", job.folder.generic_string());
    addWords("render", renderWordsOf(job, "<STARTFRAME>-<ENDFRAME>" + steps, folder), facts, describe);
    addWords("join", joinWordsIn(folder, job), facts, describe);
    return facts;
}

FarmFiles deadlineFiles(const FarmJob& job)
{
    const TemplateFacts facts = deadlineFacts(job);
    TemplateFacts script = commonFacts(Language::Shell, job);
    script.text("folder", job.folder.generic_string());
    script.text("job_file", fromHere(job.name + ".deadline.job"));
    script.text("plugin_file", fromHere(job.name + ".deadline.plugin"));
    script.text("join_job_file", fromHere(job.name + ".join.deadline.job"));
    script.text("join_plugin_file", fromHere(job.name + ".join.deadline.plugin"));
    FarmFiles made{{{fileOf(job, ".deadline.sh"), filled("deadline_submit", script)},
                       {fileOf(job, ".deadline.job"), filled("deadline_job", facts)},
                       {fileOf(job, ".deadline.plugin"), filled("deadline_plugin", facts)}},
        "bash " + shellQuoted(fileOf(job, ".deadline.sh").string())};
    if (!job.joinWords.empty()) {
        made.files.push_back({fileOf(job, ".join.deadline.job"), filled("deadline_join_job", facts)});
        made.files.push_back({fileOf(job, ".join.deadline.plugin"), filled("deadline_join_plugin", facts)});
    }
    return made;
}

} // namespace

std::string_view nameOf(Farm farm)
{
    switch (farm) {
    case Farm::Slurm: return "slurm";
    case Farm::OpenJd: return "openjd";
    case Farm::Flamenco: return "flamenco";
    case Farm::Deadline: return "deadline";
    }
    return {};
}

std::string presetFileOf(const FarmJob& job)
{
    return job.name + ".fumage.json";
}

int mostPerTask(Farm farm)
{
    return farm == Farm::OpenJd ? kMaxInOpenJdChunk : std::numeric_limits<int>::max();
}

Result<FarmFiles> makeFarmFiles(Farm farm, const FarmJob& job)
{
    if (job.perTask > mostPerTask(farm)) {
        return Error{ErrorCode::OutOfRange,
            makeMessage("a task of %1 has at most %2 frames", std::string(nameOf(farm)), mostPerTask(farm)), {},
            makeMessage("Choose fewer frames a task")};
    }
    if (Status status = checkNames(farm, job); !status) {
        return status.error();
    }
    switch (farm) {
    case Farm::Slurm: return slurmFiles(job);
    case Farm::OpenJd: return openJdFiles(job);
    case Farm::Flamenco: return flamencoFiles(job);
    case Farm::Deadline: return deadlineFiles(job);
    }
    return FarmFiles();
}

} // namespace fumage
