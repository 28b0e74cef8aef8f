#include "ui/panels/layer_view.h"

#include "ui/theme/icons.h"
#include "ui/widgets/plain_text.h"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

namespace fumage::ui {

namespace {

constexpr int kIcon = 16;
constexpr int kGap = 4;

/// How many buttons stand in front of a name: a layer alone is looked at alone.
int buttonsOf(const QAbstractItemModel& model)
{
    return model.rowCount() > 1 ? 2 : 1;
}

/// What of a row is the name with its tag.
QRect restOf(const QRect& row, const QAbstractItemModel& model)
{
    return row.adjusted(kGap + buttonsOf(model) * (kIcon + kGap), 0, 0, 0);
}

void paintButton(QPainter& painter, const QIcon& icon, const QRect& place, bool isOn, QIcon::State state)
{
    constexpr double kOff = 0.4;
    painter.save();
    painter.setOpacity(isOn ? 1.0 : kOff);
    icon.paint(&painter, place, Qt::AlignCenter, QIcon::Normal, state);
    painter.restore();
}

} // namespace

QRect LayerDelegate::placeOf(Button button, const QRect& row)
{
    const int left = row.left() + kGap + (button == Button::Eye ? 0 : kIcon + kGap);
    return {left, row.top() + (row.height() - kIcon) / 2, kIcon, kIcon};
}

std::optional<LayerDelegate::Button> LayerDelegate::buttonAt(
    const QPoint& at, const QRect& row, const QAbstractItemModel& model)
{
    constexpr int kAround = kGap / 2;
    for (const Button button : {Button::Eye, Button::Solo}) {
        const QRect place = placeOf(button, row);
        const bool isThere = button == Button::Eye || buttonsOf(model) > 1;
        if (isThere && at.x() >= place.left() - kAround && at.x() <= place.right() + kAround) {
            return button;
        }
    }
    return std::nullopt;
}

void LayerDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyleOptionViewItem row = option;
    initStyleOption(&row, index);
    const QStyle& style = *(row.widget != nullptr ? row.widget->style() : QApplication::style());
    style.drawPrimitive(QStyle::PE_PanelItemViewItem, &row, painter, row.widget);
    const bool isVisible = row.checkState == Qt::Checked;
    const bool isSolo = index.data(LayerModel::Solo).toBool();
    const bool isChosen = row.state.testFlag(QStyle::State_Selected);
    paintButton(*painter, themedIcon(isVisible ? QStringLiteral("eye") : QStringLiteral("eye-off")),
        placeOf(Button::Eye, option.rect), isVisible, QIcon::Off);
    if (buttonsOf(*index.model()) > 1) {
        // On the colour of what is chosen that of what is on would not be seen.
        paintButton(*painter, themedIcon(QStringLiteral("solo")), placeOf(Button::Solo, option.rect), isSolo,
            isSolo && !isChosen ? QIcon::On : QIcon::Off);
    }
    row.rect = restOf(option.rect, *index.model());
    const QString particles = index.data(LayerModel::Particles).toString();
    if (!particles.isEmpty()) {
        const QRect place = row.rect.adjusted(0, 0, -kGap, 0);
        painter->save();
        painter->setPen(row.palette.color(isChosen ? QPalette::HighlightedText : QPalette::PlaceholderText));
        painter->drawText(place, Qt::AlignRight | Qt::AlignVCenter, particles);
        painter->restore();
        row.rect.setRight(place.right() - row.fontMetrics.horizontalAdvance(particles) - kGap);
    }
    row.features &= ~QStyleOptionViewItem::HasCheckIndicator;
    row.backgroundBrush = Qt::NoBrush;
    row.state.setFlag(QStyle::State_HasFocus, false);
    if (!isVisible) {
        row.palette.setColor(QPalette::Text, row.palette.color(QPalette::PlaceholderText));
    }
    style.drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);
}

QSize LayerDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const QSize usual = QStyledItemDelegate::sizeHint(option, index);
    return {usual.width() + buttonsOf(*index.model()) * (kIcon + kGap), std::max(usual.height(), kIcon + kGap)};
}

void LayerDelegate::updateEditorGeometry(
    QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    editor->setGeometry(restOf(option.rect, *index.model()));
}

/// Clicks are the view's, before they choose a row.
bool LayerDelegate::editorEvent(QEvent* /*event*/, QAbstractItemModel* /*model*/,
    const QStyleOptionViewItem& /*option*/, const QModelIndex& /*index*/)
{
    return false;
}

LayerView::LayerView(Document& document, Solo& solo, LayerTransfer& transfer, QWidget* parent)
    : QListView(parent)
    , m_document(document)
    , m_solo(solo)
    , m_model(new LayerModel(document, solo, transfer, this))
{
    setObjectName(QStringLiteral("layers"));
    setAccessibleName(tr("Layers"));
    setModel(m_model);
    setItemDelegate(new LayerDelegate(this));
    setDragDropMode(QAbstractItemView::DragDrop);
    setDefaultDropAction(Qt::MoveAction);
    setDropIndicatorShown(true);
    setDragDropOverwriteMode(false);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    setUniformItemSizes(true);
    // The current row changes before it is known what is chosen with it.
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &LayerView::take);
    connect(&document, &Document::selectionChanged, this, &LayerView::follow);
    follow();
}

void LayerView::rename(std::size_t layer)
{
    edit(m_model->index(static_cast<int>(layer)));
}

/// What is chosen here is chosen in the document; one always is.
void LayerView::take()
{
    if (m_follows) {
        return;
    }
    LayerPlaces chosen;
    for (const QModelIndex& index : selectionModel()->selectedIndexes()) {
        chosen.push_back(static_cast<std::size_t>(index.row()));
    }
    const auto now = static_cast<std::size_t>(std::max(0, currentIndex().row()));
    const bool isCurrent = std::find(chosen.begin(), chosen.end(), now) != chosen.end();
    m_document.selectLayers(
        chosen.empty() || isCurrent ? LayerSelection(now, chosen) : LayerSelection(chosen.front(), chosen));
    follow();
}

void LayerView::follow()
{
    m_follows = true;
    const LayerSelection& selection = m_document.selection();
    QItemSelection rows;
    for (const std::size_t layer : selection.all()) {
        const QModelIndex index = m_model->index(static_cast<int>(layer));
        rows.select(index, index);
    }
    if (rows != selectionModel()->selection()) {
        selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    }
    const QModelIndex active = m_model->index(static_cast<int>(selection.active()));
    if (currentIndex() != active) {
        selectionModel()->setCurrentIndex(active, QItemSelectionModel::NoUpdate);
    }
    m_follows = false;
}

std::optional<LayerView::Press> LayerView::pressAt(const QPoint& at) const
{
    const QModelIndex index = indexAt(at);
    if (!index.isValid()) {
        return std::nullopt;
    }
    const auto button = LayerDelegate::buttonAt(at, visualRect(index), *m_model);
    return button ? std::optional(Press{index, *button}) : std::nullopt;
}

/// A button in front of a name leaves alone what is chosen.
void LayerView::mousePressEvent(QMouseEvent* event)
{
    const std::optional<Press> press =
        event->button() == Qt::LeftButton ? pressAt(event->position().toPoint()) : std::nullopt;
    m_isPressed = press.has_value();
    if (press) {
        click(*press, event->modifiers());
    } else {
        QListView::mousePressEvent(event);
    }
}

void LayerView::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_isPressed) {
        QListView::mouseMoveEvent(event);
    }
}

void LayerView::mouseReleaseEvent(QMouseEvent* event)
{
    if (!m_isPressed) {
        QListView::mouseReleaseEvent(event);
    }
    m_isPressed = false;
}

/// Two quick clicks on a button are two clicks.
void LayerView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (pressAt(event->position().toPoint())) {
        mousePressEvent(event);
    } else {
        QListView::mouseDoubleClickEvent(event);
    }
}

void LayerView::click(const Press& press, Qt::KeyboardModifiers modifiers)
{
    const bool isEye = press.button == LayerDelegate::Button::Eye;
    if (isEye && modifiers.testFlag(Qt::AltModifier)) {
        m_solo.toggleAlone(static_cast<std::size_t>(press.index.row()));
        return;
    }
    const int role = isEye ? static_cast<int>(Qt::CheckStateRole) : LayerModel::Solo;
    const bool isOn = isEye ? press.index.data(role).toInt() == Qt::Checked : press.index.data(role).toBool();
    m_model->setData(press.index, isEye ? QVariant(isOn ? Qt::Unchecked : Qt::Checked) : QVariant(!isOn), role);
}

void LayerView::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Delete) {
        emit deleteRequested();
    } else if (event->key() == Qt::Key_Space && currentIndex().isValid()) {
        click({currentIndex(), LayerDelegate::Button::Eye}, event->modifiers());
    } else {
        QListView::keyPressEvent(event);
    }
}

bool LayerView::viewportEvent(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto& help = static_cast<const QHelpEvent&>(*event);
        if (const std::optional<Press> press = pressAt(help.pos())) {
            QToolTip::showText(help.globalPos(),
                plainToolTip(press->button == LayerDelegate::Button::Eye
                        ? tr("Show or mute, in exports, too (Alt: look at this layer alone)")
                        : tr("Look at this layer alone: in the viewport, not in exports")),
                this);
            return true;
        }
    }
    return QListView::viewportEvent(event);
}

} // namespace fumage::ui
