#include "app/cli/playing_options.h"

#include "core/base/text.h"

namespace fumage::cli {

void PlayingOptions::addTo(CLI::App& command)
{
    command
        .add_option("--rate", rate,
            "Frames a second at which a video plays, such as 23.976 or 30000/1001; the frames stay the same. Default: "
            "the timeline's")
        ->type_name("RATE");
    command
        .add_option("--repeat", repeat,
            "How often a gif or apng plays: once, forever, or auto: for ever where its frames close a loop")
        ->check(CLI::IsMember({"auto", "once", "forever"}))
        ->capture_default_str();
}

Status PlayingOptions::applyTo(ExportPlan& plan) const
{
    plan.repeat = enumeratorNamed<Repeat, kRepeats>(repeat).value_or(plan.repeat);
    if (rate.empty()) {
        return Done{};
    }
    const Result<FrameRate> parsed = parseFrameRate(rate);
    if (!parsed) {
        Error error = parsed.error();
        error.place = std::string("--rate");
        return error;
    }
    plan.rate = parsed.value();
    return Done{};
}

} // namespace fumage::cli
