#pragma once

#include "app/cli/command.h"

#include "core/export/plan.h"

namespace fumage::cli {

/// "640x360", or "512" for both. @return whether it is two numbers from 1 to most
[[nodiscard]] bool parseTwo(const std::string& text, int most, int& first, int& second);

/// What pictures are to be rendered.
struct PictureJob {
    Effect effect;
    ExportPlan plan;
};

/// Runs the job with a progress bar, until it is done or interrupted.
[[nodiscard]] Result<std::optional<Flipbook>> writePictures(const PictureJob& job);

/// The options that the commands that render have in common.
struct PictureOptions {
    EffectOptions effect;
    std::string output;
    std::string frames;
    std::string size;
    int supersample = 0;
    std::string format;
    bool fit = false;

    void addTo(CLI::App& command, const std::string& outputHelp, const std::string& sizeHelp);
    [[nodiscard]] Result<PictureJob> load() const;
};

} // namespace fumage::cli
