#include "core/export/sheets/flipbook_options.h"

#include <bit>
#include <cstdlib>

namespace fumage {

std::array<int, 2> gridWithin(int frames, int columns, int rows, bool powersOfTwo)
{
    const auto fits = [powersOfTwo](
                          int edge) { return !powersOfTwo || std::has_single_bit(static_cast<unsigned>(edge)); };
    std::array<int, 2> best{1, 1};
    for (int x = 1; x <= columns; ++x) {
        for (int y = 1; y <= rows && x * y <= frames; ++y) {
            const int gain = x * y - best[0] * best[1];
            const bool isSquarer = std::abs(x - y) < std::abs(best[0] - best[1]);
            if (fits(x) && fits(y) && (gain > 0 || (gain == 0 && isSquarer))) {
                best = {x, y};
            }
        }
    }
    return best;
}

bool isDivided(const FlipbookOptions& options)
{
    return options.layers && *options.layers != LayerOutput::Together;
}

bool isOfShares(const FlipbookOptions& options)
{
    return options.layers && isShare(*options.layers);
}

bool isShareOfSeveral(const FlipbookOptions& sheet)
{
    return isOfShares(sheet) && sheet.layer && sheet.layer->count > 1;
}

bool isPremultiplied(const FlipbookOptions& sheet)
{
    return isShareOfSeveral(sheet) && !blendsStraight(sheet.engine);
}

BlendSpace blendSpaceOf(const FlipbookOptions& options)
{
    return holdsFloats(options.format) ? BlendSpace::Linear : options.blending.value_or(blendSpaceOf(options.engine));
}

PassSet renderedPasses(const FlipbookOptions& options)
{
    PassSet passes = passesOf(options.packs);
    passes.add(options.passes);
    return passes;
}

} // namespace fumage
