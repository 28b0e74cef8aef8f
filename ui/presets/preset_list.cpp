#include "ui/presets/preset_list.h"

#include "ui/document/layer_clipboard.h"
#include "ui/document/text.h"
#include "ui/widgets/plain_text.h"

#include <algorithm>

#include <QCoreApplication>
#include <QMimeData>
#include <QPainter>
#include <QTimer>

namespace fumage::ui {

namespace {

constexpr int kShelfRole = Qt::UserRole;

QString idOfEntry(const LibraryEntry& entry)
{
    return entry.path.empty() ? toQString(entry.id) : fromPath(entry.path);
}

/// A text of a preset; those of built-in ones in the language of the user.
QString textOf(const LibraryPreset& shelf, const std::string& text)
{
    return shelf.entry.path.empty() && !text.empty() ? QCoreApplication::translate("Presets", text.c_str())
                                                     : toQString(text);
}

QString nameOf(const LibraryPreset& shelf)
{
    return shelf.preset.name.empty() ? toQString(shelf.entry.id) : textOf(shelf, shelf.preset.name);
}

} // namespace

PresetList::PresetList(int edge, QWidget* parent)
    : QListWidget(parent)
    , m_thumbnailer(ThumbnailStore(ThumbnailStore::usualFolder()))
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
    connect(
        &m_reader, &LibraryReader::found, this, qOverload<const std::vector<LibraryPreset>&, bool>(&PresetList::add));
    connect(&m_thumbnailer, &Thumbnailer::ready, this, &PresetList::receive);
    connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        if (const Preset* preset = presetOf(item)) {
            const Preset copy = *preset; // the list may be filled anew while somebody answers a question
            emit chosen(copy);
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
    m_reader.read();
}

void PresetList::add(const std::vector<LibraryPreset>& presets, bool first)
{
    if (first) {
        m_thumbnailer.clear();
        clear();
        m_shelves.clear();
        m_items.clear();
    }
    for (const LibraryPreset& preset : presets) {
        add(preset);
    }
}

void PresetList::add(const LibraryPreset& shelf)
{
    const Preset& preset = shelf.preset;
    const QString id = idOfEntry(shelf.entry);
    auto* item = new QListWidgetItem(this);
    item->setData(kShelfRole, static_cast<int>(m_shelves.size()));
    item->setSizeHint(gridSize());
    m_shelves.push_back(shelf);
    m_items.insert(id, item);
    label(*item);
    item->setHidden(!isWanted(*item));
    if (!shelf.trouble.isEmpty()) {
        item->setToolTip(plainToolTip(shelf.trouble));
        item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
        return;
    }
    constexpr qsizetype kLongestTip = 400;
    const QString description = shortened(textOf(shelf, preset.description), kLongestTip);
    item->setToolTip(titledToolTip(shortened(nameOf(shelf)), description));
    QPixmap blank(m_edge, m_edge);
    blank.fill(QColor(30, 34, 40));
    item->setIcon(blank);
    m_thumbnailer.request(id, preset.scene, static_cast<int>(m_edge * devicePixelRatioF()));
}

void PresetList::label(QListWidgetItem& item) const
{
    const LibraryPreset* shelf = shelfOf(&item);
    const QString name = shortened(nameOf(*shelf));
    const bool favourite = m_favourites.contains(idOf(&item));
    item.setText((favourite ? QStringLiteral("★ ") : QString()) + name
        + (shelf->trouble.isEmpty() ? QString() : tr(" (broken)")));
}

void PresetList::receive(const QString& id, const QImage& image)
{
    if (QListWidgetItem* item = m_items.value(id)) {
        QPixmap pixmap = QPixmap::fromImage(image);
        pixmap.setDevicePixelRatio(devicePixelRatioF());
        item->setIcon(pixmap);
    }
}

const LibraryPreset* PresetList::shelfOf(const QListWidgetItem* item) const
{
    return &m_shelves[static_cast<std::size_t>(item->data(kShelfRole).toInt())];
}

const LibraryEntry* PresetList::entryOf(const QListWidgetItem* item) const
{
    return item == nullptr ? nullptr : &shelfOf(item)->entry;
}

const Preset* PresetList::presetOf(const QListWidgetItem* item) const
{
    return item == nullptr || !shelfOf(item)->trouble.isEmpty() ? nullptr : &shelfOf(item)->preset;
}

QString PresetList::idOf(const QListWidgetItem* item) const
{
    return idOfEntry(shelfOf(item)->entry);
}

const Preset* PresetList::presetOfId(const QString& id) const
{
    return presetOf(m_items.value(id));
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
    m_words = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    m_onlyFavourites = onlyFavourites;
    for (int i = 0; i < count(); ++i) {
        item(i)->setHidden(!isWanted(*item(i)));
    }
    setAccessibleDescription(emptyRemark());
    viewport()->update();
}

void PresetList::paintEvent(QPaintEvent* event)
{
    QListWidget::paintEvent(event);
    const QString remark = emptyRemark();
    if (!remark.isEmpty()) {
        constexpr int kMargin = 12;
        QPainter painter(viewport());
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(viewport()->rect().adjusted(kMargin, kMargin, -kMargin, -kMargin),
            Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, remark);
    }
}

QString PresetList::emptyRemark() const
{
    for (int i = 0; i < count(); ++i) {
        if (!item(i)->isHidden()) {
            return {};
        }
    }
    if (count() == 0) {
        return {};
    }
    if (m_onlyFavourites && m_favourites.isEmpty()) {
        return tr("There are no favourites yet: the menu of a preset makes it one.");
    }
    return tr("No preset matches “%1”.").arg(shortened(m_words.join(QLatin1Char(' '))));
}

bool PresetList::isWanted(const QListWidgetItem& item) const
{
    const LibraryPreset& shelf = *shelfOf(&item);
    const QString text = item.text() + QLatin1Char(' ') + textOf(shelf, shelf.preset.description) + QLatin1Char(' ')
        + toQString(shelf.preset.name + ' ' + shelf.preset.description);
    const bool found = std::all_of(
        m_words.begin(), m_words.end(), [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
    return found && (!m_onlyFavourites || m_favourites.contains(idOf(&item)));
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
        if (const Preset* preset = presetOf(items.constFirst())) {
            addLayers(*dragged, *preset);
        }
    }
    return dragged;
}

} // namespace fumage::ui
