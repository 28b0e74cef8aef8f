#include "core/preset/layer_node.h"

#include "core/base/joined.h"
#include "core/effect/value.h"
#include "core/preset/preset_keys.h"

#include <algorithm>

namespace fumage {

Result<bool> readLayerMember(const std::string& key, const JsonNode& node, const NodeTalk& talk, Layer& layer)
{
    const bool isText = node.type == JsonNode::Type::String;
    const auto wrong = [&](const Message& expected) {
        return talk.error(node, ErrorCode::WrongType, makeMessage("%1: expected %2", key, expected), {});
    };
    if (key == kLayerName || key == kLayerFrom) {
        if (!isText) {
            return wrong(makeMessage("a text in quotes"));
        }
        if (node.string.size() > kMaxLayerName) {
            return talk.error(node, ErrorCode::TooLarge, makeMessage("a layer's name of %1 bytes", node.string.size()),
                makeMessage("Names have at most %1", kMaxLayerName));
        }
        (key == kLayerName ? layer.name : layer.from) = node.string;
        return true;
    }
    if (key == kLayerVisible || key == kLayerLocked) {
        if (node.type != JsonNode::Type::Bool) {
            return wrong(kindName(Kind::Bool));
        }
        (key == kLayerVisible ? layer.visible : layer.locked) = node.flag;
        return true;
    }
    if (key == kLayerTag) {
        const auto tag = std::find(kColourTags.begin(), kColourTags.end(), node.string);
        if (!isText || tag == kColourTags.end()) {
            return wrong(makeMessage("a colour: %1", joined(kColourTags)));
        }
        layer.tag = static_cast<ColourTag>(tag - kColourTags.begin());
        return true;
    }
    return false;
}

} // namespace fumage
