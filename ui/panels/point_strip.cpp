#include "ui/panels/point_strip.h"

#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>

namespace fumage::ui {

PointStrip::PointStrip(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
}

void PointStrip::select(int index)
{
    m_selected = std::clamp(index, 0, std::max(0, count() - 1));
    update();
}

void PointStrip::touched(int index, bool finished)
{
    select(index);
    emit changed(finished);
}

void PointStrip::remove(int index)
{
    if (count() < 2 || index < 0) {
        return;
    }
    erase(index);
    touched(index, true);
}

void PointStrip::addActions(QMenu& menu, const QPoint& global)
{
    const int index = pointAt(mapFromGlobal(global));
    if (index < 0) {
        return;
    }
    addPointActions(menu, index);
    menu.addAction(tr("Delete the point"), this, [this, index] { remove(index); })->setEnabled(count() > 1);
    menu.addSeparator();
}

void PointStrip::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    const int index = pointAt(event->position());
    if (index >= 0) {
        m_dragging = true;
        select(index);
    } else if (const int added = insertAt(event->position()); added >= 0) {
        m_dragging = true;
        touched(added, false);
    }
}

void PointStrip::mouseMoveEvent(QMouseEvent* event)
{
    if (m_dragging) {
        moveTo(m_selected, event->position());
        touched(m_selected, false);
    }
}

void PointStrip::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_dragging && event->button() == Qt::LeftButton) {
        m_dragging = false;
        emit changed(true);
    }
}

void PointStrip::keyPressEvent(QKeyEvent* event)
{
    const auto go = [&](int right, int up) {
        if (step(m_selected, right, up)) {
            touched(m_selected, true);
        } else {
            QWidget::keyPressEvent(event);
        }
    };
    switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace: remove(m_selected); break;
    case Qt::Key_PageUp: select(m_selected - 1); break;
    case Qt::Key_PageDown: select(m_selected + 1); break;
    case Qt::Key_Insert:
        if (const int added = insertAfter(m_selected); added >= 0) {
            touched(added, true);
        }
        break;
    case Qt::Key_Left: go(-1, 0); break;
    case Qt::Key_Right: go(1, 0); break;
    case Qt::Key_Up: go(0, 1); break;
    case Qt::Key_Down: go(0, -1); break;
    default: QWidget::keyPressEvent(event);
    }
}

} // namespace fumage::ui
