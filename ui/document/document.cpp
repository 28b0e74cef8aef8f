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

} // namespace

Document::Document(const Preset& first, QObject* parent)
    : QObject(parent)
    , m_preset(first)
    , m_reference(first.effect)
{
    m_views.reset(first.effect.camera);
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
    return m_unsavedFromStart || m_fileIsGone || !m_undo.isClean() || !(effect().camera == m_reference.camera);
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
    for (const Assignment& assignment : assignments) {
        const Parameter& stored = storedParameter(*assignment.parameter);
        const Value before = stored.get(effect());
        const Value after = clampValue(stored, storedValue(*assignment.parameter, assignment.value, effect())).value;
        if (before != after) {
            changes.push_back({&stored, before, after});
        }
    }
    if (!changes.empty()) {
        m_undo.push(new EditCommand(*this, std::move(changes), text, gesture));
    }
}

void Document::replaceEffect(const Effect& effect, const QString& text, Gesture gesture)
{
    if (!(effect == m_preset.effect)) {
        m_undo.push(new ReplaceCommand(*this, effect, text, gesture));
    }
}

void Document::reset(const Parameter& parameter)
{
    const Parameter& stored = storedParameter(parameter);
    edit({{&stored, stored.get(m_reference)}}, tr("Reset %1").arg(fullLabelOf(parameter)));
}

void Document::moveCamera(const Camera& camera, Gesture gesture)
{
    const Camera moved = clamped(camera);
    if (!(moved == effect().camera)) {
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
    Effect moved = effect();
    moved.camera = camera;
    write(moved, differences(effect(), moved));
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
    m_path = path;
    m_read = read ? *read : path.isEmpty() ? FileMark() : markOfFile(path);
    m_views.reset(preset.effect.camera);
    rebase();
    emit loaded();
    emit viewsChanged();
    announce(allParameters());
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
    replaceEffect(work.effect, tr("Unsaved work"));
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
    const Effect effect = reading.value().preset.effect;
    m_read = now;
    replaceEffect(effect, tr("Reload"));
    m_preset = reading.value().preset;
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
    m_reference = m_preset.effect;
    emit titleChanged();
}

void Document::write(const Effect& effect, std::vector<const Parameter*> changed)
{
    m_preset.effect = effect;
    announce(std::move(changed));
}

void Document::announce(std::vector<const Parameter*> changed)
{
    EffectChange change{std::move(changed)};
    for (const Parameter* parameter : change.parameters) {
        change.stale = std::max(change.stale, parameter->dirties);
    }
    emit effectChanged(change);
}

} // namespace fumage::ui
