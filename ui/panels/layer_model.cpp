#include "ui/panels/layer_model.h"

#include "ui/theme/icons.h"
#include "ui/widgets/plain_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <QCoreApplication>
#include <QLocale>
#include <QMimeData>
#include <QPainter>

namespace fumage::ui {

namespace {

/// The colours of tags, in their order.
constexpr std::array<QRgb, 8> kTags{
    0x00000000, 0xffd0594f, 0xffd98a3d, 0xffd0b63f, 0xff6faf59, 0xff5b93d6, 0xff9a75c9, 0xff9a9a9a};

std::size_t layerOf(const QModelIndex& index)
{
    return static_cast<std::size_t>(index.row());
}

/// How many there are once the quality is worked in.
QString particlesText(const Scene& scene, std::size_t layer)
{
    return QLocale().toString(sampledLayer(scene, layer)->emitter.count);
}

} // namespace

QString LayerModel::statisticsOf(std::size_t layer) const
{
    const Scene& scene = m_document.scene();
    QStringList lines{layerLabel(scene, layer), tr("%1 particles").arg(particlesText(scene, layer))};
    if (const std::optional<std::size_t> parent = parentOf(scene, layer)) {
        lines += tr("Born on %1").arg(layerLabel(scene, *parent));
    }
    const double all = std::accumulate(m_work.begin(), m_work.end(), 0.0);
    if (!scene.layers[layer].visible) {
        lines += tr("Muted: it is neither simulated nor exported");
    } else if (m_rows > 1 && layer < m_work.size() && all > 0.0) {
        constexpr double kPercent = 100.0;
        lines += tr("%1 % of the simulation").arg(std::lround(kPercent * m_work[layer] / all));
    }
    return lines.join(QLatin1Char('\n'));
}

void LayerModel::noteWork(const std::vector<double>& particleSteps)
{
    if (std::accumulate(particleSteps.begin(), particleSteps.end(), 0.0) <= 0.0) {
        return;
    }
    constexpr double kShareOfNewest = 0.2;
    m_work.resize(particleSteps.size(), 0.0);
    for (std::size_t layer = 0; layer < m_work.size(); ++layer) {
        m_work[layer] += kShareOfNewest * (particleSteps[layer] - m_work[layer]);
    }
}

QIcon LayerModel::iconOf(ColourTag tag)
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

LayerModel::LayerModel(Document& document, ui::Solo& solo, LayerTransfer& transfer, QObject* parent)
    : QAbstractListModel(parent)
    , m_document(document)
    , m_solo(solo)
    , m_transfer(transfer)
    , m_rows(static_cast<int>(document.scene().layers.size()))
{
    connect(&document, &Document::layersChanged, this, &LayerModel::follow);
    connect(&solo, &ui::Solo::changed, this, &LayerModel::repaint);
    connect(&document, &Document::effectChanged, this, &LayerModel::repaint); // another number of particles
}

void LayerModel::follow()
{
    const int rows = static_cast<int>(m_document.scene().layers.size());
    if (rows == m_rows) { // what views have of them stays
        repaint();
        return;
    }
    m_work.clear();
    beginResetModel();
    m_rows = rows;
    endResetModel();
}

void LayerModel::repaint()
{
    emit dataChanged(index(0), index(m_rows - 1));
}

int LayerModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_rows;
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
    case Qt::ToolTipRole: return plainToolTip(statisticsOf(layerOf(index)));
    case Particles: return m_rows > 1 ? particlesText(scene, layerOf(index)) : QString();
    case Solo: return m_solo.contains(layerOf(index));
    default: return {};
    }
}

bool LayerModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    switch (role) {
    case Qt::CheckStateRole:
        setLayersVisible(m_document, togetherWith(layerOf(index)), value.toInt() == Qt::Checked);
        return true;
    case Qt::EditRole: renameLayer(m_document, layerOf(index), value.toString()); return true;
    case Solo: m_solo.set(togetherWith(layerOf(index)), value.toBool()); return true;
    default: return false;
    }
}

LayerPlaces LayerModel::togetherWith(std::size_t layer) const
{
    const LayerSelection& selection = m_document.selection();
    return selection.contains(layer) ? selection.all() : LayerPlaces{layer};
}

Qt::ItemFlags LayerModel::flags(const QModelIndex& index) const
{
    if (!index.isValid()) {
        return Qt::ItemIsDropEnabled; // between the rows
    }
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsUserCheckable
        | Qt::ItemIsDragEnabled;
}

/// Rows of another window, or of another program, are layers to be added and none of these.
QString LayerModel::rowsMimeType() const
{
    return QStringLiteral("application/x-fumage-rows-%1-%2")
        .arg(QCoreApplication::applicationPid())
        .arg(reinterpret_cast<quintptr>(this), 0, 16);
}

QStringList LayerModel::mimeTypes() const
{
    return {rowsMimeType(), layersMimeType(), QStringLiteral("text/uri-list")};
}

QMimeData* LayerModel::mimeData(const QModelIndexList& indexes) const
{
    LayerPlaces layers;
    QByteArrayList rows;
    for (const QModelIndex& index : indexes) {
        layers.push_back(layerOf(index));
        rows += QByteArray::number(index.row());
    }
    std::sort(layers.begin(), layers.end());
    auto* data = new QMimeData;
    data->setData(rowsMimeType(), rows.join(' '));
    addLayers(*data, m_document.preset(), layers);
    return data;
}

LayerPlaces LayerModel::rowsOf(const QMimeData& data) const
{
    LayerPlaces rows;
    for (const QByteArray& number : data.data(rowsMimeType()).split(' ')) {
        bool isNumber = false;
        const int row = number.toInt(&isNumber);
        if (isNumber && row >= 0 && row < m_rows) {
            rows.push_back(static_cast<std::size_t>(row));
        }
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

bool LayerModel::dropMimeData(
    const QMimeData* data, Qt::DropAction action, int row, int /*column*/, const QModelIndex& parent)
{
    const int at = row >= 0 ? row : parent.isValid() ? parent.row() : m_rows;
    const auto before = static_cast<std::size_t>(std::min(at, m_rows));
    const LayerPlaces rows = rowsOf(*data);
    if (rows.empty() || action == Qt::CopyAction) {
        return m_transfer.drop(*data, before);
    }
    moveLayers(m_document, rows, before);
    return false; // the rows are moved already: the view has nothing to take away
}

} // namespace fumage::ui
