#pragma once

#include "core/export/export_task.h"
#include "core/export/sheets/flipbook_options.h"
#include "core/export/manifest/manifest.h"
#include "core/export/manifest/recording.h"
#include "core/export/sequence.h"
#include "core/scene/scene.h"

#include <filesystem>

namespace fumage {

/// The kind of jobs that are of frames.
inline constexpr std::string_view kFramesKind = "frames";

/// The job that frames are made by. Frames of one job are the same, whatever ranges it is divided into.
[[nodiscard]] ManifestJob jobOf(const Scene& scene, const SequenceOptions& options);

/// How the frames of a job are rendered: format, passes and step; not their range and name.
/// @error WrongType: it is not of frames, or has settings that are not known
[[nodiscard]] Result<SequenceOptions> sequenceOf(const ManifestJob& job);

/// The kind of jobs that are flipbooks.
inline constexpr std::string_view kFlipbookKind = "flipbook";

/// The job that a flipbook is made by. Its name belongs to it: the file beside the picture names it.
[[nodiscard]] ManifestJob jobOf(const Scene& scene, const FlipbookOptions& options);

/// How the flipbook of a job is rendered; its output has no folder.
/// @error WrongType: it is no flipbook, or does not say all of it, as those of Fumage before this was known
[[nodiscard]] Result<FlipbookOptions> flipbookOf(const ManifestJob& job);

/// The frames of which the file is there as a whole: it reads to its end and has the right size, and where it carries a
/// preset and a frame these are the right ones. O(pixels of those files).
/// @param kept hears of each
/// @error Cancelled; that of kept
[[nodiscard]] Result<std::vector<int>> framesThere(const Scene& scene, const SequenceOptions& options,
    const std::function<Status(int frame, const Content& content)>& kept, const std::stop_token& stop = {});

/// renderSequence(), but for frames that are there already, and with a manifest of them all. It is written too where
/// the work ends early, of what was done until then.
[[nodiscard]] Status renderRecorded(
    const Scene& scene, SequenceOptions options, const Recording& recording, const ExportTask& task = {});

/// Writes numbered files that are no pictures, with a manifest of them. It is written too where the work ends early.
/// @param manifest empty: none
/// @param files    how they are named
/// @param write    writes them, and tells the sink of each, which is empty where nobody hears
[[nodiscard]] Status recordNumbered(const ManifestJob& job, const std::filesystem::path& manifest,
    const NumberedFiles& files, const std::function<Status(const FrameSink& written)>& write);

/// Writes the manifest of a flipbook that has been written.
/// @error those of readFile() and ManifestRecorder
[[nodiscard]] Status recordFlipbook(
    const Scene& scene, const FlipbookOptions& options, const std::filesystem::path& manifest);

} // namespace fumage
