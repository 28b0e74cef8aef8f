#include "ui/export/file_conflict.h"

#include "ui/document/text.h"

#include "core/base/text.h"
#include "core/export/manifest/manifest_parts.h"
#include "core/export/output_name.h"

#include <array>

#include <QCoreApplication>
#include <QDir>

namespace fumage::ui {

namespace {

/// "smoke" becomes "smoke-2", and that "smoke-3".
std::string withNextNumber(const std::string& name)
{
    const std::size_t dash = name.rfind('-');
    const std::optional<std::int64_t> number =
        dash == std::string::npos ? std::nullopt : parseInteger(std::string_view(name).substr(dash + 1));
    return number ? name.substr(0, dash + 1) + std::to_string(*number + 1) : name + "-2";
}

/// The next number stands before that of the frame, and before the ending.
std::filesystem::path withNextNumber(const std::filesystem::path& path, ExportKind kind)
{
    const std::string name = path.filename().string();
    std::size_t end = name.size() - path.extension().string().size();
    if (const std::optional<NumberPlace> place = isNumbered(kind) ? numberPlaceIn(name) : std::nullopt) {
        end = std::min(end, place->at);
    }
    while (end > 1 && std::string_view("_-. ").find(name[end - 1]) != std::string_view::npos) {
        --end;
    }
    return path.parent_path() / (withNextNumber(name.substr(0, end)) + name.substr(end));
}

/// The files of a job that are there already: how many, and the first.
std::pair<int, std::filesystem::path> filesThere(const ExportJob& job)
{
    std::pair<int, std::filesystem::path> there;
    for (const std::filesystem::path& file : filesOf(job.preset.scene, job.plan)) {
        if (std::error_code unknown; std::filesystem::exists(file, unknown) && there.first++ == 0) {
            there.second = file;
        }
    }
    return there;
}

} // namespace

JobFiles filesOf(const ExportJobs& jobs)
{
    JobFiles files;
    for (const std::shared_ptr<const ExportJob>& job : jobs) {
        static_cast<void>(files.add(*job));
    }
    return files;
}

ExportPlan numberedOn(ExportJob job, const JobFiles& others)
{
    ExportPlan& plan = job.plan;
    const bool hasManifest = !manifestOf(plan).empty();
    do {
        plan.output = withNextNumber(plan.output, plan.kind);
        if (hasManifest) {
            plan.recording.manifest = manifestBeside(plan.output);
        }
    } while (filesThere(job).first > 0 || !others.check(job));
    return plan;
}

FileConflict findClash(const ExportJob& job, const ExportJobs& others)
{
    const JobFiles written = filesOf(others);
    const auto [there, first] = filesThere(job);
    ExportJob named = job;
    named.name = job.plan.output.filename().string();
    FileConflict clash{written.check(named), there, fromPath(first), job.plan};
    if (!clash.isNone()) {
        clash.free = numberedOn(job, written);
    }
    return clash;
}

namespace {

/// The answer that leaves what is there alone.
QString saveAs(const ExportPlan& free)
{
    return QCoreApplication::translate("Exports", "Save as %1").arg(shortened(fromPath(free.output.filename()), 40));
}

ConflictPolicy askAboutFiles(QWidget* parent, const AskForChoice& ask, const FileConflict& clash)
{
    const QString first = QDir::toNativeSeparators(clash.first);
    const QString text = clash.there == 1
        ? QCoreApplication::translate("Exports", "%1 already exists.").arg(first)
        : QCoreApplication::translate("Exports", "%1 of the files are there already; the first is %2.")
              .arg(clash.there)
              .arg(first);
    const int answer = ask(parent,
        {.name = QStringLiteral("exportClashBox"),
            .title = QCoreApplication::translate("Exports", "Export"),
            .text = text,
            .answers = {saveAs(clash.free), QCoreApplication::translate("Exports", "Overwrite"),
                QCoreApplication::translate("Exports", "Cancel")}}); // Return loses nothing
    constexpr std::array kAnswers{ConflictPolicy::KeepBoth, ConflictPolicy::Overwrite, ConflictPolicy::Cancel};
    return kAnswers[static_cast<std::size_t>(answer)];
}

/// Two exports of the queue never write one file, whatever the user would make of it.
ConflictPolicy askAboutQueue(QWidget* parent, const AskForChoice& ask, const FileConflict& clash)
{
    const int answer = ask(parent,
        {.name = QStringLiteral("exportQueuedBox"),
            .title = QCoreApplication::translate("Exports", "Export"),
            .text = translated(clash.apart.error()),
            .answers = {saveAs(clash.free), QCoreApplication::translate("Exports", "Cancel")}});
    return answer == 0 ? ConflictPolicy::KeepBoth : ConflictPolicy::Cancel;
}

} // namespace

std::optional<ExportPlan> settled(QWidget* parent, const AskForChoice& ask, const FileConflict& clash,
    const ExportPlan& plan, std::optional<ConflictPolicy>& answered)
{
    if (clash.isNone()) {
        return plan;
    }
    if (!clash.apart && answered != ConflictPolicy::KeepBoth) {
        answered = askAboutQueue(parent, ask, clash);
    } else if (!answered) {
        answered = askAboutFiles(parent, ask, clash);
    }
    switch (*answered) {
    case ConflictPolicy::Overwrite: return plan;
    case ConflictPolicy::KeepBoth: return clash.free;
    case ConflictPolicy::Cancel: answered.reset(); break;
    }
    return std::nullopt;
}

} // namespace fumage::ui
