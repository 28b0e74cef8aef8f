#include "app/cli/manifest_option.h"

#include "core/system/path.h"
#include "core/export/manifest/manifest_parts.h"

namespace fumage::cli {

void ManifestOption::addTo(CLI::App& command)
{
    command
        .add_flag("--manifest", text,
            "Write a manifest beside the files, for 'fumage-cli verify': hashes of what they hold, and what they are "
            "made of. --manifest=FILE names it; frames have their range in its name")
        ->type_name("FILE");
}

std::filesystem::path ManifestOption::fileFor(const std::filesystem::path& output) const
{
    return text == "true" ? manifestBeside(output) : pathFrom(text);
}

} // namespace fumage::cli
