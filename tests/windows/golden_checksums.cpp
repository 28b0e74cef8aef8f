// Prints the checksums of tests/golden/golden.txt as this machine computes them:  golden_checksums [presets]...

#include "tests/golden/checksum.h"

#include "core/preset/library.h"

#include <cstdio>
#include <string>
#include <vector>

using namespace fumage;
using namespace fumage::tests;

namespace {

Status printLine(const std::string& id)
{
    const Result<Image> image = goldenPicture(goldenScene(id));
    if (!image) {
        return image.error();
    }
    std::printf("%s\n", goldenLine(id, image.value()).c_str());
    std::fflush(stdout);
    return Done{};
}

} // namespace

int main(int argc, char** argv)
{
    std::vector<std::string> ids(argv + 1, argv + argc);
    if (ids.empty()) {
        for (const LibraryEntry& entry : builtinPresets()) {
            ids.push_back(entry.id);
        }
    }
    for (const std::string& id : ids) {
        if (const Status status = printLine(id); !status) {
            std::fprintf(stderr, "%s\n", status.error().text().c_str());
            return 1;
        }
    }
    return 0;
}
