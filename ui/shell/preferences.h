#pragma once

#include "ui/concurrency/async_request.h"

#include <QDialog>

class QFormLayout;
class QLabel;

namespace fumage::ui {

class AppServices;

/// What a person sets once, on one page. Each choice takes effect as it is made, or with the next start where it says
/// so.
class Preferences : public QDialog {
    Q_OBJECT

public:
    Preferences(AppServices& services, QWidget* parent);

private:
    void addFace(QFormLayout& form);
    void addViewport(QFormLayout& form);
    void addMachine(QFormLayout& form);
    void addCache(QFormLayout& form);
    void addStart(QFormLayout& form);
    /// Says what the thumbnails take on the disk, which is asked on another thread.
    /// @param clears removes them before
    void measureCache(bool clears);

    AppServices& m_services;
    QLabel* m_cacheSize;
    AsyncRequest m_cache; ///< last: its thread ends first
};

} // namespace fumage::ui
