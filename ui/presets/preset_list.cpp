#include "ui/presets/preset_list.h"

#include "ui/document/text.h"

#include <algorithm>

#include <QFileInfo>
#include <QMimeData>
#include <QTimer>

namespace fumage::ui {

namespace {

constexpr int kShelfRole = Qt::UserRole;

QString idOfEntry(const LibraryEntry& entry)
{
    return entry.path.empty() ? toQString(entry.id) : toQString(entry.path.string());
}

} // namespace

PresetList::PresetList(int edge, QWidget* parent)
    : QListWidget(parent)
    , m_edge(edge)
{
    setObjectName(QStringLiteral("presetList"));
    setAccessibleName(tr("Presets"));
    setViewMode(QListView::IconMode);
    setResizeMode(QListView::Adjust);
    setMovement(QListView::Static);
    setIconSize({edge, edge});
    setGridSize({edge + 16, edge + 36});
    setWordWrap(true);
    setUniformItemSizes(true);
    setDragEnabled(true);
    setSpacing(2);
    connect(&m_thumbnailer, &Thumbnailer::ready, this, &PresetList::receive);
    connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        if (const Preset* preset = presetOf(item)) {
            emit chosen(*preset);
        }
    });
}

void PresetList::showEvent(QShowEvent* event)
{
    QListWidget::showEvent(event);
    if (!m_loaded) {
        m_loaded = true;
        // The smoke itself comes first.
        constexpr int kLaterMs = 400;
        QTimer::singleShot(kLaterMs, this, &PresetList::reload);
    }
}

void PresetList::reload()
{
    m_loaded = true;
    m_thumbnailer.clear();
    clear();
    m_shelves.clear();
    for (const LibraryEntry& entry : presetsIn(userPresetFolder())) {
        addEntry(entry);
    }
    for (const LibraryEntry& entry : builtinPresets()) {
        addEntry(entry);
    }
    setFavourites(m_favourites);
}

void PresetList::addEntry(const LibraryEntry& entry)
{
    Result<PresetReading> reading = loadPreset(entry);
    auto* item = new QListWidgetItem(this);
    item->setData(kShelfRole, static_cast<int>(m_shelves.size()));
    item->setSizeHint(gridSize());
    if (!reading) {
        m_shelves.push_back({entry, {}, true});
        item->setToolTip(toQString(reading.error().text()));
        item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
        label(*item);
        return;
    }
    m_shelves.push_back({entry, std::move(reading).value().preset, false});
    const Preset& preset = m_shelves.back().preset;
    item->setToolTip(QStringLiteral("<b>%1</b><br>%2").arg(toQString(preset.name).toHtmlEscaped(), toQString(preset.description).toHtmlEscaped()));
    QPixmap blank(m_edge, m_edge);
    blank.fill(QColor(30, 34, 40));
    item->setIcon(blank);
    label(*item);
    m_thumbnailer.request(idOfEntry(entry), preset.effect, static_cast<int>(m_edge * devicePixelRatioF()));
}

void PresetList::label(QListWidgetItem& item) const
{
    const Shelf* shelf = shelfOf(&item);
    const QString name = shelf->preset.name.empty() ? toQString(shelf->entry.id) : toQString(shelf->preset.name);
    const bool favourite = m_favourites.contains(idOf(&item));
    item.setText((favourite ? QStringLiteral("★ ") : QString()) + name + (shelf->broken ? tr(" (broken)") : QString()));
}

void PresetList::receive(const QString& id, const QImage& image)
{
    for (int i = 0; i < count(); ++i) {
        if (idOf(item(i)) == id) {
            QPixmap pixmap = QPixmap::fromImage(image);
            pixmap.setDevicePixelRatio(devicePixelRatioF());
            item(i)->setIcon(pixmap);
        }
    }
}

const PresetList::Shelf* PresetList::shelfOf(const QListWidgetItem* item) const
{
    return &m_shelves[static_cast<std::size_t>(item->data(kShelfRole).toInt())];
}

const LibraryEntry* PresetList::entryOf(const QListWidgetItem* item) const
{
    return item == nullptr ? nullptr : &shelfOf(item)->entry;
}

const Preset* PresetList::presetOf(const QListWidgetItem* item) const
{
    return item == nullptr || shelfOf(item)->broken ? nullptr : &shelfOf(item)->preset;
}

QString PresetList::idOf(const QListWidgetItem* item) const
{
    return idOfEntry(shelfOf(item)->entry);
}

const Preset* PresetList::presetOfId(const QString& id) const
{
    for (const Shelf& shelf : m_shelves) {
        if (idOfEntry(shelf.entry) == id && !shelf.broken) {
            return &shelf.preset;
        }
    }
    return nullptr;
}

void PresetList::setFavourites(const QStringList& ids)
{
    m_favourites = ids;
    for (int i = 0; i < count(); ++i) {
        label(*item(i));
    }
}

void PresetList::filter(const QString& words, bool onlyFavourites)
{
    const QStringList all = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (int i = 0; i < count(); ++i) {
        const Shelf* shelf = shelfOf(item(i));
        const QString text = item(i)->text() + QLatin1Char(' ') + toQString(shelf->preset.description);
        const bool found = std::all_of(all.begin(), all.end(), [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
        item(i)->setHidden(!found || (onlyFavourites && !m_favourites.contains(idOf(item(i)))));
    }
}

QString PresetList::mimeType()
{
    return QStringLiteral("application/x-fumage-preset-id");
}

QMimeData* PresetList::mimeData(const QList<QListWidgetItem*>& items) const
{
    auto* dragged = new QMimeData;
    if (!items.isEmpty()) {
        dragged->setData(mimeType(), idOf(items.constFirst()).toUtf8());
    }
    return dragged;
}

} // namespace fumage::ui
