#include "ui/document/document.h"

#include "ui/document/commands.h"
#include "ui/document/parameter_text.h"
#include "ui/document/text.h"

#include "core/base/file.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"

#include <algorithm>

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

} // namespace

Document::Document(QObject* parent)
    : QObject(parent)
{
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
    return m_unsavedFromStart || !m_undo.isClean();
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
        const Value before = assignment.parameter->get(effect());
        const Value after = clampValue(*assignment.parameter, assignment.value).value;
        if (before != after) {
            changes.push_back({assignment.parameter, before, after});
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
    edit({{&parameter, parameter.get(m_reference)}}, tr("Reset %1").arg(fullLabelOf(parameter)));
}

void Document::load(const Preset& preset, const QString& path, bool modified)
{
    m_unsavedFromStart = modified; // before the undo stack says that nothing has changed
    m_undo.clear();
    m_preset = preset;
    m_path = path;
    rebase();
    emit loaded();
    announce(allParameters());
}

void Document::loadUnsaved(const Preset& work, const QString& path)
{
    const Result<PresetReading> original = readPresetFile(toPath(path));
    if (path.isEmpty() || !original) {
        load(work, path, true);
        return;
    }
    // Never for a moment a document that is saved: the copy of the work would be taken from the disk.
    load(original.value().preset, path, true);
    replaceEffect(work.effect, tr("Unsaved work"));
    m_unsavedFromStart = false;
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
    m_unsavedFromStart = false;
    m_undo.setClean();
    rebase();
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
        change.stale = std::max(change.stale, parameter->stage);
    }
    emit effectChanged(change);
}

} // namespace fumage::ui
