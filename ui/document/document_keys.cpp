// What a document does with key frames.

#include "ui/document/document.h"

#include "ui/document/parameter_text.h"

#include "core/effect/shown_table.h"

namespace fumage::ui {

Effect Document::referenceNow(std::size_t layer) const
{
    return m_referenceScene.effectAt(referenceLayer(layer), m_seconds);
}

void Document::addKeyed(const Scene& scene, std::size_t layer, std::vector<const Parameter*>& changed)
{
    const Tracks tracks = layer < scene.layers.size() ? scene.allTracks(layer) : scene.tracks;
    for (const Track& track : tracks.all()) {
        changed.push_back(track.parameter);
    }
}

void Document::setSeconds(double seconds)
{
    if (seconds == m_seconds) {
        return;
    }
    m_seconds = seconds;
    std::vector<const Parameter*> changed;
    addKeyed(scene(), layer(), changed);
    if (changed.empty()) {
        return;
    }
    m_effect = scene().effectAt(layer(), m_seconds);
    m_reference = referenceNow(layer());
    emit effectChanged({std::move(changed), DirtyStage::Shade, false});
}

void Document::setAutoKey(bool on)
{
    if (on != m_autoKey) {
        m_autoKey = on;
        emit autoKeyChanged(on);
    }
}

const Track* Document::track(const Parameter& parameter) const
{
    return scene().tracksOf(parameter, layer()).find(parameter);
}

bool Document::canEdit(const Parameter& parameter) const
{
    return parameter.scope == Scope::Scene || !scene().layers[layer()].locked;
}

Track Document::withKey(const Parameter& parameter, const Value& value) const
{
    const Track* before = track(parameter);
    Track keyed = before != nullptr ? *before : Track{&parameter, {}};
    setKeyValue(keyed, m_seconds, value);
    return keyed;
}

bool Document::getsKey(const Parameter& parameter) const
{
    return track(parameter) != nullptr || (m_autoKey && canAnimate(parameter));
}

void Document::editKeys(const std::vector<EditCommand::Change>& changes, const QString& text, Gesture gesture)
{
    Scene after = scene();
    Effect base = after.effect(layer());
    for (const EditCommand::Change& change : changes) {
        if (!getsKey(*change.parameter)) {
            change.parameter->set(base, change.after);
        }
    }
    after.assign(layer(), base);
    QStringList names;
    for (const EditCommand::Change& change : changes) {
        if (getsKey(*change.parameter)) {
            after.tracksOf(*change.parameter, layer()).set(withKey(*change.parameter, change.after));
        }
        names += fullLabelOf(*change.parameter);
    }
    replaceScene(
        after, m_selection, text.isEmpty() ? tr("Key %1").arg(names.join(QStringLiteral(", "))) : text, gesture);
}

void Document::reset(const Parameter& parameter)
{
    const Parameter& stored = storedParameter(parameter);
    const QString text = tr("Reset %1").arg(fullLabelOf(parameter));
    const std::size_t from = referenceLayer(layer());
    const Track* before = m_referenceScene.tracksOf(stored, from).find(stored);
    if (before == nullptr && track(stored) == nullptr) {
        edit({{&stored, stored.get(m_reference)}}, text);
    } else if (canEdit(stored)) {
        Scene after = scene();
        Effect base = after.effect(layer());
        stored.set(base, stored.get(m_referenceScene.effect(from)));
        after.assign(layer(), base);
        after.tracksOf(stored, layer()).set(before != nullptr ? *before : Track{&stored, {}});
        replaceScene(after, m_selection, text);
    }
}

} // namespace fumage::ui
