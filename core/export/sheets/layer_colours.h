#pragma once

#include "core/export/image_file.h"
#include "core/export/pass_picture.h"
#include "core/export/sheets/flipbook_options.h"

#include <span>
#include <vector>

namespace fumage {

/// Most light that is hidden by what is drawn later: where less than this of a layer is seen, what it gives is drawn
/// with the layer that comes next.
inline constexpr float kMinSeen = 1.0F / 1024.0F;

/// How the colours of layers are stored.
struct LayerStore {
    ImageFormat format = ImageFormat::Png8;
    BlendSpace space = BlendSpace::Encoded; ///< of formats without floats: in which the layers add up; others: linear
    bool isStraight = false; ///< else premultiplied; of stacked layers in formats without floats
};

/// Divides the colours of a sheet among its layers.
///
/// Let p be the sheet as it is shown over black, premultiplied, and a its alpha, as files have them (after the view
/// transform; in formats of floats as they are), and C_k what layer k gives to it. Layer k has p_k = p C_k / sum C, of
/// each channel, and a_k, whose sum is a: what it covers, and, of the alpha that clear flames have by their light, its
/// share of the light.
///
/// Contribution: p_k and a_k. Encoded, the bytes of all layers add up to those of the sheet, round(p), exactly: what is
/// left of rounding down goes to those that lost most. Linear, what rounding leaves goes into the next layer.
///
/// Stacked: with T_k = 1 - sum of a_j over the layers j that are drawn later, a'_k = a_k / T_k and c'_k = p_k / T_k.
/// Each layer drawn over those before it, c' + (1 - a') behind, gives p + (1 - a) behind: the layers j > k leave the
/// product of 1 - a'_j = (T_j - a_j) / T_j = T_(j-1) / T_j of layer k, which is T_k, and T_0 = 1 - a of what is behind.
/// Both are found with the rounded a' of the layers above. What is drawn so far must fit into the numbers from 0 to 1
/// over anything, white as well, or a screen of 8 bits clips it before the layers above dim it: the sum of p_j over j
/// <= k is at most T_k - T_0, what these layers cover. Light beyond that, which is in front of layers that are drawn
/// later, and what rounding leaves, goes into the layer that is drawn next; of the last one all fits, since the sheet
/// does. So the sheet is right within half a step of the last layer, in whatever numbers somebody blends. Floats are
/// not bounded.
///
/// Straight: c'_k / a'_k in place of c'_k, which is 1 at most where p_k is no more than a_k. Any a_k whose sum is a
/// give the same picture; so those that are drawn last have as much as their light first, and what alpha is left goes
/// by what layers cover beyond theirs. Where layers of different colours lie in one another there may be too little for
/// those that are drawn first, whose light goes into the next: any of the last have together as much alpha as light, or
/// all of it, so all light fits.
///
/// @param whole  linear, premultiplied, without background
/// @param layers contributions to it, in the order in which they are drawn, two or more
/// @param output Stacked, or Contribution in a format without floats: in floats these are the contributions
/// @return of each layer premultiplied or straight colours and alpha as numbers of the format: floats, or steps / full;
/// straight colours go on under transparency, see bleedColours()
/// O(pixels * layers). The same bits for any thread count.
[[nodiscard]] std::vector<DataImage> layerColours(const Image& whole, std::span<const PassSheet> layers,
    const Scene& scene, LayerOutput output, const LayerStore& how);

} // namespace fumage
