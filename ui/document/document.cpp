#include "ui/document/document.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"

#include "core/system/file.h"
#include "core/effect/parameter_table.h"
#include "core/effect/shown_table.h"
#include "core/effect/value.h"
#include "core/preset/preset_file.h"

#include <algorithm>
#include <utility>

#include <QFileInfo>

namespace fumage::ui {

namespace {

std::vector<const Parameter*> allParameters()
{
    std::vector<const Parameter*> all;
    for (const Parameter& parameter : parameterTable()) {
        all.push_back(&parameter);
    }
    return all;
}

/// With each value in its hard range.
Camera clamped(const Camera& camera)
{
    Effect effect;
    effect.camera = camera;
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.group() == "camera") {
            parameter.set(effect, clampValue(parameter, parameter.get(effect)).value);
        }
    }
    return effect.camera;
}

/// The first stage that a change of key frames makes stale.
DirtyStage staleBetween(const Tracks& before, const Tracks& after)
{
    DirtyStage stale = DirtyStage::Shade;
    const auto look = [&](const Tracks& tracks, const Tracks& others) {
        for (const Track& track : tracks.all()) {
            const Track* other = others.find(*track.parameter);
            if (other == nullptr || *other != track) {
                stale = std::max(stale, track.parameter->dirties);
            }
        }
    };
    look(before, after);
    look(after, before);
    return stale;
}

/// A layer, that on which it is born, seen or not, that on which that one is born, and so on.
std::vector<std::size_t> withParents(const Scene& scene, std::size_t layer)
{
    std::vector<std::size_t> line{layer};
    for (auto next = parentOf(scene, layer); next && line.size() <= scene.layers.size();
         next = parentOf(scene, *next)) {
        line.push_back(*next);
    }
    return line;
}

/// The same of two layers with those that they are born on.
DirtyStage staleBetween(const Scene& before, std::size_t layerBefore, const Scene& after, std::size_t layerAfter)
{
    const std::vector<std::size_t> was = withParents(before, layerBefore);
    const std::vector<std::size_t> is = withParents(after, layerAfter);
    if (was.size() != is.size()) {
        return DirtyStage::Air; // which those that are born on others do not feed
    }
    DirtyStage stale = DirtyStage::Shade;
    for (std::size_t i = 0; i < is.size(); ++i) {
        for (const Parameter* parameter : differences(before.effect(was[i]), after.effect(is[i]))) {
            stale = std::max(stale, parameter->dirties);
        }
        stale = std::max(stale, staleBetween(before.allTracks(was[i]), after.allTracks(is[i])));
    }
    return stale;
}

/// The first stage of the work that has to be done again where one scene takes another's place.
DirtyStage staleBetween(const Scene& before, const Scene& after)
{
    const std::vector<std::size_t> was = before.visibleLayers();
    const std::vector<std::size_t> is = after.visibleLayers();
    if (was.size() != is.size()) {
        return DirtyStage::Air;
    }
    DirtyStage stale = DirtyStage::Shade;
    for (std::size_t i = 0; i < is.size(); ++i) {
        stale = std::max(stale, staleBetween(before, was[i], after, is[i]));
    }
    return stale;
}

/// Whether a parameter of a group changes over time.
bool hasKeys(const Tracks& tracks, std::string_view group)
{
    return std::any_of(tracks.all().begin(), tracks.all().end(),
        [&](const Track& track) { return track.parameter->group() == group; });
}

/// Whether one scene looks as another: their markers alone differ.
bool hasOtherMarkersAlone(const Scene& one, const Scene& other)
{
    if (one.markers == other.markers) {
        return false;
    }
    Scene same = one;
    same.markers = other.markers;
    return same == other;
}

/// Whether lists of the layers of both look alike.
bool hasSameLayers(const Scene& one, const Scene& other)
{
    const auto looksAlike = [](const Layer& a, const Layer& b) {
        return a.name == b.name && a.visible == b.visible && a.locked == b.locked && a.tag == b.tag;
    };
    return std::equal(one.layers.begin(), one.layers.end(), other.layers.begin(), other.layers.end(), looksAlike);
}

} // namespace

Document::Document(const Preset& first, QObject* parent)
    : QObject(parent)
    , m_preset(first)
    , m_unknown(first)
    , m_effect(first.scene.effect())
    , m_referenceScene(first.scene)
    , m_reference(m_effect)
{
    m_views.reset(first.scene.camera);
    connect(&m_undo, &QUndoStack::cleanChanged, this, &Document::titleChanged);
}

QString Document::displayName() const
{
    if (!m_path.isEmpty()) {
        return onOneLine(nameOfFile(m_path));
    }
    return m_preset.name.empty() ? tr("Untitled") : shortened(onOneLine(toQString(m_preset.name)));
}

bool Document::isModified() const
{
    return m_unsavedFromStart || m_fileIsGone || !m_undo.isClean() || !(scene().camera == m_referenceScene.camera);
}

Gesture Document::beginGesture()
{
    return {++m_gestures};
}

void Document::edit(const Parameter& parameter, const Value& value, Gesture gesture)
{
    edit({{&parameter, value}}, {}, gesture);
}

void Document::edit(const std::vector<Assignment>& assignments, const QString& text, Gesture gesture)
{
    std::vector<EditCommand::Change> changes;
    std::vector<const Parameter*> refused;
    for (const Assignment& assignment : assignments) {
        const Parameter& stored = storedParameter(*assignment.parameter);
        if (!canEdit(stored)) {
            refused.push_back(&stored);
            continue;
        }
        const Value before = stored.get(effect());
        const Value after = clampValue(stored, storedValue(*assignment.parameter, assignment.value, effect())).value;
        if (before != after) {
            changes.push_back({&stored, before, after});
        }
    }
    if (!refused.empty()) {
        emit effectChanged({std::move(refused), DirtyStage::Shade, false}); // editors show again what is there
    }
    const bool isKeyed = std::any_of(changes.begin(), changes.end(),
        [this](const EditCommand::Change& change) { return getsKey(*change.parameter); });
    if (isKeyed) {
        editKeys(changes, text, gesture);
    } else if (!changes.empty()) {
        m_undo.push(new EditCommand(*this, std::move(changes), text, gesture));
    }
}

void Document::replaceEffect(const Effect& effect, const QString& text, Gesture gesture)
{
    Scene scene = m_preset.scene;
    if (scene.layers[layer()].locked) {
        scene.setSurroundings(effect);
    } else {
        scene.assign(layer(), effect);
    }
    replaceScene(scene, m_selection, text, gesture);
}

void Document::replaceScene(const Scene& scene, const LayerSelection& selection, const QString& text, Gesture gesture)
{
    if (!(scene == m_preset.scene)) {
        m_undo.push(new ReplaceCommand(*this, scene, selection, text, gesture));
    }
}

void Document::selectLayers(const LayerSelection& selection)
{
    if (!(selection == m_selection)) {
        write(m_preset.scene, selection, differences(m_effect, m_preset.scene.effect(selection.active())));
    }
}

void Document::moveCamera(const Camera& camera, Gesture gesture)
{
    const Camera moved = clamped(camera);
    if (hasKeys(scene().tracks, "camera")) {
        std::vector<Assignment> assignments;
        Effect there = effect();
        there.camera = moved;
        for (const Parameter* parameter : differences(effect(), there)) {
            assignments.push_back({parameter, parameter->get(there)});
        }
        edit(assignments, tr("Move the camera"), gesture);
    } else if (!(moved == effect().camera)) {
        m_views.move(effect().camera, moved, gesture.id);
        setCamera(moved);
    }
}

void Document::previousView()
{
    setCamera(m_views.previous(effect().camera));
}

void Document::nextView()
{
    setCamera(m_views.next(effect().camera));
}

void Document::setCamera(const Camera& camera)
{
    const bool wasModified = isModified();
    Scene moved = m_preset.scene;
    moved.camera = camera;
    write(moved, m_selection, differences(effect(), moved.effect(layer())));
    emit viewsChanged();
    if (isModified() != wasModified) {
        emit titleChanged();
    }
}

void Document::load(const Preset& preset, const QString& path, bool modified, const std::optional<FileMark>& read)
{
    m_unsavedFromStart = modified; // before the undo stack says that nothing has changed
    m_fileIsGone = false;
    m_undo.clear();
    m_preset = preset;
    m_unknown.reset(preset);
    m_selection = {};
    m_effect = preset.scene.effectAt(0, m_seconds);
    m_path = path;
    m_read = read ? *read : path.isEmpty() ? FileMark() : markOfFile(path);
    m_views.reset(preset.scene.camera);
    rebase();
    emit loaded();
    emit viewsChanged();
    emit effectChanged({allParameters(), DirtyStage::Air});
    emit layersChanged();
    emit selectionChanged();
}

void Document::loadUnsaved(const Preset& work, const QString& path, const std::optional<FileMark>& read)
{
    const FileMark now = path.isEmpty() ? FileMark() : markOfFile(path);
    const Result<PresetReading> original = readPresetFile(toPath(path));
    if (path.isEmpty() || !original) {
        load(work, path, true, read ? *read : now);
        return;
    }
    // Never for a moment a document that is saved: the copy of the work would be taken from the disk.
    load(original.value().preset, path, true, read ? *read : now);
    replaceScene(work.scene, 0, tr("Unsaved work"));
    m_unsavedFromStart = false;
    emit titleChanged();
}

DiskState Document::compareWithDisk()
{
    const FileMark now = m_path.isEmpty() ? m_read : markOfFile(m_path);
    const DiskState state = now == m_read ? DiskState::Same : now.isEmpty() ? DiskState::Gone : DiskState::Changed;
    const bool wasGone = std::exchange(m_fileIsGone, state == DiskState::Gone);
    if (wasGone != m_fileIsGone) {
        emit titleChanged();
    }
    return state;
}

Result<PresetReading> Document::reload()
{
    const FileMark now = markOfFile(m_path);
    Result<PresetReading> reading = readPresetFile(toPath(m_path));
    if (!reading) {
        return reading;
    }
    const Scene& scene = reading.value().preset.scene;
    m_read = now;
    replaceScene(scene, std::min(layer(), scene.layers.size() - 1), tr("Reload"));
    m_preset = reading.value().preset;
    m_unknown.reset(m_preset);
    m_unsavedFromStart = false;
    m_fileIsGone = false;
    m_undo.setClean();
    rebase();
    return reading;
}

void Document::keepOverDisk()
{
    m_read = markOfFile(m_path);
    m_unsavedFromStart = true;
    emit titleChanged();
}

Status Document::save(const QString& path)
{
    Preset preset = m_preset;
    if (preset.name.empty() || path != m_path) {
        preset.name = nameOfFile(path).toStdString();
    }
    clearLeftovers(toPath(QFileInfo(path).path())); // of programs that were killed while they saved here
    if (Status status = writePresetFile(toPath(path), preset); !status) {
        return status;
    }
    m_preset = preset;
    m_path = path;
    m_read = markOfText(formatPreset(preset));
    m_unsavedFromStart = false;
    m_fileIsGone = false;
    m_undo.setClean();
    rebase(); // also where nothing but the camera had changed
    return Done{};
}

void Document::rebase()
{
    m_referenceScene = m_preset.scene;
    m_reference = referenceNow(layer());
    emit titleChanged();
}

void Document::write(const Scene& scene, const LayerSelection& selection, std::vector<const Parameter*> changed)
{
    const DirtyStage stale = staleBetween(m_preset.scene, scene);
    const bool isSameScene = &scene == &m_preset.scene;
    const bool isOfScene = !isSameScene && !hasOtherMarkersAlone(m_preset.scene, scene);
    const bool hasSameList = hasSameLayers(m_preset.scene, scene);
    const bool isSameSelection = selection == m_selection;
    const std::size_t active = selection.active();
    const bool isSameLayer = active == layer();
    addKeyed(m_preset.scene, layer(), changed);
    addKeyed(scene, active, changed);
    const std::size_t before = m_preset.scene.layers.size();
    m_preset.scene = scene;
    m_unknown.follow(m_preset, before);
    m_selection = selection;
    m_effect = scene.effectAt(active, m_seconds);
    m_reference = referenceNow(active);
    if (!isSameScene || !isSameLayer) {
        emit effectChanged({std::move(changed), stale, isOfScene});
    }
    if (!hasSameList) {
        emit layersChanged();
    }
    if (!hasSameList || !isSameSelection) {
        emit selectionChanged();
    }
}

} // namespace fumage::ui
