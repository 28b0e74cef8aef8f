#pragma once

#include <QList>
#include <QString>

class QCoreApplication;

namespace fumage::ui {

struct Language {
    QString code; ///< as in the name of its file: "sv", "zh_CN"; "en" has none
    QString name; ///< in the language itself
};

/// The languages that the program speaks, English first.
[[nodiscard]] const QList<Language>& languages();

/// Loads the texts of a language for everything that is made from now on.
/// @param code of languages(), or empty for that of the system
/// @return whether there are such texts; English needs none
bool applyLanguage(QCoreApplication& application, const QString& code);

} // namespace fumage::ui
