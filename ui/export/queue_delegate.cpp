#include "ui/export/queue_delegate.h"

#include "ui/export/export_queue.h"
#include "ui/face/theme.h"

#include <QApplication>
#include <QPainter>

namespace fumage::ui {

namespace {

constexpr int kMargin = 8;
constexpr int kGap = 3;
constexpr int kBar = 4; ///< height of the bar, which only the one that runs has; others keep its place, so that nothing jumps

/// Where the parts of a row lie.
struct Places {
    QRect name;
    QRect place;
    QRect bar;
    QRect told;
};

Places placesIn(const QRect& row, int line)
{
    const QRect inner = row.adjusted(kMargin, kMargin, -kMargin, -kMargin);
    Places at;
    at.name = QRect(inner.left(), inner.top(), inner.width(), line);
    at.place = at.name.translated(0, line + kGap);
    at.told = at.place.translated(0, line + kGap);
    at.bar = QRect(inner.left(), at.told.bottom() + kGap, inner.width(), kBar);
    return at;
}

void drawText(QPainter& painter, const QRect& where, const QString& text)
{
    painter.drawText(where, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, painter.fontMetrics().elidedText(text, Qt::ElideRight, where.width()));
}

void drawBar(QPainter& painter, const QRect& where, double share, const QColor& ground, const QColor& colour)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(where, kBar / 2.0, kBar / 2.0);
    if (share > 0.0) {
        QRectF done(where);
        done.setWidth(where.width() * share);
        painter.setBrush(colour);
        painter.drawRoundedRect(done, kBar / 2.0, kBar / 2.0);
    }
}

} // namespace

void QueueDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyleOptionViewItem ground = option;
    const QWidget* widget = option.widget;
    const QStyle* style = widget != nullptr ? widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &ground, painter, widget);

    const auto state = static_cast<ExportState>(index.data(ExportQueue::StateRole).toInt());
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    const ThemeColours& colours = themeColours(isDark(option.palette));
    const QColor quiet = selected ? QColor::fromRgb(colours.onAccent) : QColor::fromRgb(colours.quiet);
    const QColor strong = selected ? QColor::fromRgb(colours.onAccent) : QColor::fromRgb(colours.text);
    const Places at = placesIn(option.rect, option.fontMetrics.height());
    painter->save();
    QFont bold = option.font;
    bold.setWeight(QFont::DemiBold);
    painter->setFont(bold);
    painter->setPen(strong);
    drawText(*painter, at.name, index.data(Qt::DisplayRole).toString());
    painter->setFont(option.font);
    painter->setPen(quiet);
    drawText(*painter, at.place, index.data(ExportQueue::PlaceRole).toString());
    const bool isMarked = !selected && (state == ExportState::Failed || state == ExportState::Held);
    painter->setPen(isMarked ? QColor::fromRgb(colours.mark) : quiet);
    drawText(*painter, at.told, index.data(ExportQueue::ToldRole).toString());
    if (state == ExportState::Running) {
        drawBar(*painter, at.bar, index.data(ExportQueue::ShareRole).toDouble(), QColor::fromRgb(colours.edge), selected ? strong : QColor::fromRgb(colours.accent));
    }
    painter->restore();
}

QSize QueueDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const
{
    const Places at = placesIn(QRect(0, 0, 200, 0), option.fontMetrics.height());
    return {at.bar.width() / 2, at.bar.bottom() + 1 + kMargin};
}

void QueueDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const
{
    constexpr int kFrame = 4; // of the field
    editor->setGeometry(placesIn(option.rect, option.fontMetrics.height()).name.adjusted(-kFrame, -kFrame, kFrame, kFrame));
}

} // namespace fumage::ui
