#include "ui/timeline/key_clipboard.h"

#include "core/preset/track_node.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>

#include <algorithm>

namespace fumage::ui {

namespace {

struct KeyClipboard {
    Q_DECLARE_TR_FUNCTIONS(KeyClipboard)
};

/// What is on the clipboard, as far as it is key frames.
std::vector<Track> copiedTracks()
{
    const std::string text = QGuiApplication::clipboard()->text().toStdString();
    constexpr std::size_t kMaxText = std::size_t{1} << 20U;
    const Result<JsonNode> root = text.size() < kMaxText ? parseJson(text) : Error{};
    std::vector<Track> tracks;
    if (!root || root.value().type != JsonNode::Type::Array) {
        return tracks;
    }
    const NodeTalk talk{[](const JsonNode&, ErrorCode code, const Message& message, const Message& remedy) {
                            return Error{code, message, {}, remedy};
                        },
        [](const JsonNode&, const Message&) {}};
    for (const Scope scope : {Scope::Scene, Scope::Layer}) {
        if (const Result<TracksReading> reading = readTracks(root.value(), scope, text, talk)) {
            const std::span<const Track> all = reading.value().tracks.all();
            tracks.insert(tracks.end(), all.begin(), all.end());
        }
    }
    return tracks;
}

} // namespace

void copyKeys(const Document& document, const std::vector<KeyPlace>& keys)
{
    std::string text;
    const Tracks tracks = document.scene().allTracks(document.layer());
    for (Track track : tracks.all()) {
        std::erase_if(track.keys, [&](const KeyFrame& key) {
            return std::find(keys.begin(), keys.end(), KeyPlace{track.parameter, key.seconds}) == keys.end();
        });
        if (!track.keys.empty()) {
            text += (text.empty() ? "[" : ",\n") + formatTrack(track);
        }
    }
    if (!text.empty()) {
        QGuiApplication::clipboard()->setText(QString::fromStdString(text + "]"));
    }
}

bool hasCopiedKeys()
{
    return !copiedTracks().empty();
}

std::vector<KeyPlace> pasteKeys(Document& document)
{
    const std::vector<Track> copied = copiedTracks();
    double first = kMaxKeySeconds;
    for (const Track& track : copied) {
        first = std::min(first, track.keys.front().seconds);
    }
    std::vector<KeyPlace> added;
    std::vector<Track> tracks;
    for (const Track& from : copied) {
        const Track* before = document.track(*from.parameter);
        Track track = before != nullptr ? *before : Track{from.parameter, {}, from.before, from.after};
        for (KeyFrame key : from.keys) {
            key.seconds += document.seconds() - first;
            setKey(track, key);
            added.push_back({from.parameter, key.seconds});
        }
        if (checkTrack(track)) {
            tracks.push_back(std::move(track));
        }
    }
    replaceTracks(document, tracks, KeyClipboard::tr("Paste key frames"));
    return added;
}

} // namespace fumage::ui
