#include "ui/panels/layer_list.h"

#include "ui/document/layer_edits.h"
#include "ui/theme/icons.h"
#include "ui/widgets/plain_text.h"

#include <algorithm>
#include <array>

#include <QHBoxLayout>
#include <QListView>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kMargin = 8;
constexpr int kMaxRows = 8; ///< that are seen at once
const QString kRows = QStringLiteral("application/x-fumage-layer");

/// The colours of tags, in their order.
constexpr std::array<QRgb, 8> kTags{
    0x00000000, 0xffd0594f, 0xffd98a3d, 0xffd0b63f, 0xff6faf59, 0xff5b93d6, 0xff9a75c9, 0xff9a9a9a};

QIcon iconOf(ColourTag tag)
{
    constexpr int kEdge = 12;
    QPixmap pixmap(kEdge, kEdge);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor::fromRgba(kTags[static_cast<std::size_t>(tag)]));
    painter.drawEllipse(pixmap.rect().adjusted(1, 1, -1, -1));
    return pixmap;
}

QString nameOf(ColourTag tag)
{
    switch (tag) {
    case ColourTag::None: return LayerList::tr("None");
    case ColourTag::Red: return LayerList::tr("Red");
    case ColourTag::Orange: return LayerList::tr("Orange");
    case ColourTag::Yellow: return LayerList::tr("Yellow");
    case ColourTag::Green: return LayerList::tr("Green");
    case ColourTag::Blue: return LayerList::tr("Blue");
    case ColourTag::Violet: return LayerList::tr("Violet");
    case ColourTag::Grey: return LayerList::tr("Grey");
    }
    return {};
}

std::size_t layerOf(const QModelIndex& index)
{
    return static_cast<std::size_t>(index.row());
}

} // namespace

LayerModel::LayerModel(Document& document, QObject* parent)
    : QAbstractListModel(parent)
    , m_document(document)
{
    connect(&document, &Document::layersChanged, this, [this] {
        beginResetModel();
        endResetModel();
    });
}

int LayerModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_document.scene().layers.size());
}

QVariant LayerModel::data(const QModelIndex& index, int role) const
{
    const Scene& scene = m_document.scene();
    if (!index.isValid() || layerOf(index) >= scene.layers.size()) {
        return {};
    }
    const Layer& layer = scene.layers[layerOf(index)];
    switch (role) {
    case Qt::DisplayRole: return layerLabel(scene, layerOf(index));
    case Qt::EditRole: return QString::fromStdString(layer.name);
    case Qt::CheckStateRole: return layer.visible ? Qt::Checked : Qt::Unchecked;
    case Qt::DecorationRole: return layer.locked ? themedIcon(QStringLiteral("lock")) : iconOf(layer.tag);
    case Qt::ToolTipRole: return plainToolTip(layerLabel(scene, layerOf(index)));
    default: return {};
    }
}

bool LayerModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role == Qt::CheckStateRole) {
        setLayerVisible(m_document, layerOf(index), value.toInt() == Qt::Checked);
        return true;
    }
    if (role == Qt::EditRole) {
        renameLayer(m_document, layerOf(index), value.toString());
        return true;
    }
    return false;
}

Qt::ItemFlags LayerModel::flags(const QModelIndex& index) const
{
    if (!index.isValid()) {
        return Qt::ItemIsDropEnabled; // between the rows
    }
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsUserCheckable
        | Qt::ItemIsDragEnabled;
}

QStringList LayerModel::mimeTypes() const
{
    return {kRows};
}

QMimeData* LayerModel::mimeData(const QModelIndexList& indexes) const
{
    auto* data = new QMimeData;
    data->setData(kRows, QByteArray::number(indexes.isEmpty() ? -1 : indexes.front().row()));
    return data;
}

bool LayerModel::dropMimeData(
    const QMimeData* data, Qt::DropAction /*action*/, int row, int /*column*/, const QModelIndex& parent)
{
    bool isNumber = false;
    const int from = data->data(kRows).toInt(&isNumber);
    const int before = row >= 0 ? row : parent.isValid() ? parent.row() : rowCount();
    if (isNumber && from >= 0 && from < rowCount() && before != from && before != from + 1) {
        moveLayer(
            m_document, static_cast<std::size_t>(from), static_cast<std::size_t>(before > from ? before - 1 : before));
    }
    return false; // the row is moved already: the view has nothing to take away
}

LayerList::LayerList(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_model(new LayerModel(document, this))
    , m_view(new QListView(this))
    , m_add(makeIconButton(this, QStringLiteral("layers.add"), QStringLiteral("add"), tr("Add a layer")))
    , m_duplicate(makeIconButton(
          this, QStringLiteral("layers.duplicate"), QStringLiteral("duplicate"), tr("Duplicate the layer")))
    , m_remove(makeIconButton(this, QStringLiteral("layers.delete"), QStringLiteral("delete"), tr("Delete the layer")))
{
    setObjectName(QStringLiteral("layerList"));
    m_view->setObjectName(QStringLiteral("layers"));
    m_view->setAccessibleName(tr("Layers"));
    m_view->setModel(m_model);
    m_view->setDragDropMode(QAbstractItemView::InternalMove);
    m_view->setSelectionMode(QAbstractItemView::SingleSelection);
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_view->setUniformItemSizes(true);
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(0);
    for (QToolButton* button : {m_add, m_duplicate, m_remove}) {
        buttons->addWidget(button);
    }
    buttons->addStretch();
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, 0);
    layout->setSpacing(2);
    layout->addWidget(m_view, 1);
    layout->addLayout(buttons);
    connect(m_add, &QToolButton::clicked, this, [this] { addLayer(m_document); });
    connect(m_duplicate, &QToolButton::clicked, this, [this] { duplicateLayer(m_document, current()); });
    connect(m_remove, &QToolButton::clicked, this, [this] { removeLayer(m_document, current()); });
    connect(m_view, &QListView::customContextMenuRequested, this, &LayerList::openMenu);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& now) {
        if (!m_follows && now.isValid()) {
            m_document.selectLayer(layerOf(now));
        }
    });
    connect(&document, &Document::layersChanged, this, &LayerList::follow);
    follow();
}

void LayerList::follow()
{
    m_follows = true;
    m_view->setCurrentIndex(m_model->index(static_cast<int>(current())));
    m_follows = false;
    const int rows = m_model->rowCount();
    m_duplicate->setVisible(rows > 1);
    m_remove->setVisible(rows > 1);
    m_add->setEnabled(m_document.scene().layers.size() < kMaxLayers);
    m_duplicate->setEnabled(m_add->isEnabled());
    const int row = std::max(m_view->sizeHintForRow(0), fontMetrics().height());
    const int buttons = rows > 1 ? 3 * m_add->sizeHint().height() : m_add->sizeHint().height();
    m_view->setFixedHeight(std::max(std::min(rows, kMaxRows) * row + 2 * m_view->frameWidth() + 2, buttons));
}

void LayerList::openMenu(const QPoint& at)
{
    const QModelIndex index = m_view->indexAt(at);
    if (!index.isValid()) {
        return;
    }
    const std::size_t layer = layerOf(index);
    const Layer& shown = m_document.scene().layers[layer];
    QMenu menu(this);
    const auto add = [&](const QString& text, const auto& work) {
        connect(menu.addAction(text), &QAction::triggered, this, work);
    };
    add(tr("Rename"), [this, index] { m_view->edit(index); });
    add(shown.visible ? tr("Mute") : tr("Show"),
        [this, layer, visible = !shown.visible] { setLayerVisible(m_document, layer, visible); });
    add(shown.locked ? tr("Unlock") : tr("Lock"),
        [this, layer, locked = !shown.locked] { setLayerLocked(m_document, layer, locked); });
    QMenu* tags = menu.addMenu(tr("Colour tag"));
    for (std::size_t i = 0; i < kTags.size(); ++i) {
        const auto tag = static_cast<ColourTag>(i);
        connect(tags->addAction(iconOf(tag), nameOf(tag)), &QAction::triggered, this,
            [this, layer, tag] { setLayerTag(m_document, layer, tag); });
    }
    menu.addSeparator();
    add(tr("Duplicate"), [this, layer] { duplicateLayer(m_document, layer); });
    add(tr("Delete"), [this, layer] { removeLayer(m_document, layer); });
    menu.exec(m_view->viewport()->mapToGlobal(at));
}

} // namespace fumage::ui
