#include "ui/panels/layer_transfer.h"

#include "ui/document/text.h"
#include "ui/panels/paste_dialog.h"

#include "core/preset/preset_file.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>
#include <QUrl>

namespace fumage::ui {

namespace {

constexpr const char* kClipboard = "the clipboard";

/// What is dropped holds the program that it comes from until it is taken: messages come later.
template <class Work>
void later(QObject& context, Work work)
{
    QMetaObject::invokeMethod(&context, std::move(work), Qt::QueuedConnection);
}

} // namespace

LayerTransfer::LayerTransfer(Document& document, QWidget& parent)
    : m_document(document)
    , m_parent(parent)
{
}

bool LayerTransfer::canPaste()
{
    const QMimeData* data = QApplication::clipboard()->mimeData();
    return data != nullptr && (data->hasFormat(layersMimeType()) || data->hasText());
}

void LayerTransfer::copy(const LayerPlaces& layers) const
{
    QApplication::clipboard()->setMimeData(copiedLayers(m_document.preset(), layers));
}

void LayerTransfer::cut(const LayerPlaces& layers)
{
    copy(layers);
    removeLayers(m_document, layers, tr("Cut %1").arg(layersLabel(m_document.scene(), layers)));
}

void LayerTransfer::insert(const PresetReading& reading, const QString& name, std::size_t at, const QString& text)
{
    const std::size_t left = insertLayers(m_document, at, reading.preset, name, text);
    if (left > 0) {
        emit news(tr("A scene has at most %1 layers: %2 were left out.").arg(kMaxLayers).arg(left));
    }
    QStringList warnings;
    for (const Message& warning : reading.warnings) {
        warnings += translated(warning);
    }
    if (!warnings.isEmpty()) {
        emit refused(shortened(onOneLine(name)), warnings.join(QLatin1Char('\n')));
    }
}

void LayerTransfer::add(const LayerTemplate& from)
{
    const Result<PresetReading> reading = layersOf(from, m_document);
    if (!reading) {
        emit refused(tr("Cannot add “%1”").arg(from.name), translated(reading.error()));
        return;
    }
    insert(reading.value(), from.name, m_document.layer() + 1, tr("Add “%1”").arg(from.name));
}

void LayerTransfer::paste()
{
    if (!canPaste()) {
        return;
    }
    const Result<PresetReading> reading = layersOf(*QApplication::clipboard()->mimeData(), kClipboard);
    if (!reading) {
        emit refused(tr("Cannot paste layers"), translated(reading.error()));
        return;
    }
    const Scene& scene = reading.value().preset.scene;
    LayerPlaces all(scene.layers.size());
    const QString name = tr("Pasted layer");
    insert(reading.value(), name, m_document.selection().all().back() + 1,
        tr("Paste %1").arg(scene.layers.size() == 1 ? layerLabel(scene, 0) : layersLabel(scene, all)));
}

void LayerTransfer::pasteParameters(const LayerPlaces& layers)
{
    if (!canPaste()) {
        return;
    }
    const Result<PresetReading> reading = layersOf(*QApplication::clipboard()->mimeData(), kClipboard);
    if (!reading) {
        emit refused(tr("Cannot paste parameters"), translated(reading.error()));
        return;
    }
    const Scene& scene = reading.value().preset.scene;
    const QString name = layerLabel(scene, 0);
    auto* dialog = new PasteDialog(name, layersLabel(m_document.scene(), layers), m_groups, &m_parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, layer = scene.layers.front(), name] {
        m_groups = dialog->groups();
        pasteGroups(m_document, m_document.selection().all(), layer, m_groups, name);
    });
    dialog->open(); // nothing else is chosen meanwhile
}

void LayerTransfer::dropFile(const QString& path, std::size_t before)
{
    const Result<PresetReading> reading = readPresetFile(toPath(path));
    if (!reading) {
        emit refused(tr("Cannot add layers"), translated(reading.error()));
        return;
    }
    const QString name = nameOfFile(path);
    insert(reading.value(), name, std::min(before, m_document.scene().layers.size()), addingLayersOf(name));
}

bool LayerTransfer::drop(const QMimeData& data, std::size_t before)
{
    if (data.hasFormat(layersMimeType())) {
        later(*this, [this, before, reading = layersOf(data, {})] {
            if (!reading) {
                emit refused(tr("Cannot add layers"), translated(reading.error()));
                return;
            }
            const QString name = toQString(reading.value().preset.name);
            insert(reading.value(), name, std::min(before, m_document.scene().layers.size()), addingLayersOf(name));
        });
        return true;
    }
    QStringList files;
    for (const QUrl& url : data.urls()) {
        files += url.isLocalFile() ? QStringList(url.toLocalFile()) : QStringList();
    }
    // The last first: each comes before the place that was pointed at.
    for (auto file = files.crbegin(); file != files.crend(); ++file) {
        later(*this, [this, path = *file, before] { dropFile(path, before); });
    }
    return !files.isEmpty();
}

} // namespace fumage::ui
