; Installs Fumage for one user, without an administrator.  makensis -DVERSION=.. -DSTAGE=folder -DICON=.ico -DOUT=.exe
Target amd64-unicode
SetCompressor /SOLID lzma
RequestExecutionLevel user
ManifestDPIAware true
!include MUI2.nsh
!include FileFunc.nsh
!include LogicLib.nsh

!define UNINSTALL "Software\Microsoft\Windows\CurrentVersion\Uninstall\Fumage"
!define CLASSES "Software\Classes"

Name "Fumage"
OutFile "${OUT}"
InstallDir "$LOCALAPPDATA\Programs\Fumage"
InstallDirRegKey HKCU "${UNINSTALL}" "InstallLocation"
!define MUI_ICON "${ICON}"
!define MUI_UNICON "${ICON}"
!define MUI_FINISHPAGE_RUN "$INSTDIR\fumage.exe"
!insertmacro MUI_PAGE_LICENSE "${STAGE}/LICENSE.txt"
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"
!insertmacro MUI_LANGUAGE "Swedish"
!insertmacro MUI_LANGUAGE "SimpChinese"
LangString Running ${LANG_ENGLISH} "Fumage is running. Close it, then try again."
LangString Running ${LANG_SWEDISH} "Fumage körs. Stäng det och försök sedan igen."
LangString Running ${LANG_SIMPCHINESE} "Fumage 正在运行。请先关闭它，然后重试。"

; The programs offer to open a kind of file; which one does by default stays as it was.
!macro Offer ending class
    WriteRegStr HKCU "${CLASSES}\${ending}\OpenWithProgids" "${class}" ""
!macroend
!macro OfferNoMore ending class
    DeleteRegValue HKCU "${CLASSES}\${ending}\OpenWithProgids" "${class}"
!macroend
; A program that runs can neither be replaced nor deleted: nothing is done before it is closed. Who asks for no questions gets the exit code 2.
!macro WaitForEnd program
    ${DoWhile} ${FileExists} "$INSTDIR\${program}"
        ClearErrors
        FileOpen $0 "$INSTDIR\${program}" a
        ${IfNot} ${Errors}
            FileClose $0
            ${ExitDo}
        ${EndIf}
        ${If} ${Cmd} `MessageBox MB_RETRYCANCEL|MB_ICONEXCLAMATION "$(Running)" /SD IDCANCEL IDCANCEL`
            Abort
        ${EndIf}
    ${Loop}
!macroend
!macro Class class text
    WriteRegStr HKCU "${CLASSES}\${class}" "" "${text}"
    WriteRegStr HKCU "${CLASSES}\${class}\DefaultIcon" "" "$INSTDIR\fumage.exe,0"
    WriteRegStr HKCU "${CLASSES}\${class}\shell\open\command" "" '"$INSTDIR\fumage.exe" "%1"'
!macroend

Section
    ; A folder of other things stays theirs: our README.txt, uninstall.exe and licences would take the place of their own.
    ; One that is called Fumage is ours, whatever users have left in it.
    ${DirState} "$INSTDIR" $0
    ${GetFileName} "$INSTDIR" $1
    ${If} $0 = 1
    ${AndIf} $1 != "Fumage"
    ${AndIfNot} ${FileExists} "$INSTDIR\fumage.exe"
        StrCpy $INSTDIR "$INSTDIR\Fumage"
    ${EndIf}
    !insertmacro WaitForEnd "fumage.exe"
    !insertmacro WaitForEnd "fumage-cli.exe"
    SetOutPath "$INSTDIR"
    RMDir /r "$INSTDIR\share\fumage" ; of an older version
    RMDir /r "$INSTDIR\licences"
    File /r "${STAGE}/*"
    WriteUninstaller "$INSTDIR\uninstall.exe"
    CreateShortcut "$SMPROGRAMS\Fumage.lnk" "$INSTDIR\fumage.exe"

    !insertmacro Class "Fumage.Preset" "Fumage smoke preset"
    !insertmacro Class "Fumage.Picture" "Picture of smoke"
    !insertmacro Offer ".json" "Fumage.Preset"
    !insertmacro Offer ".png" "Fumage.Picture"
    !insertmacro Offer ".exr" "Fumage.Picture"
    WriteRegStr HKCU "Software\Microsoft\Windows\CurrentVersion\App Paths\fumage.exe" "" "$INSTDIR\fumage.exe"

    WriteRegStr HKCU "${UNINSTALL}" "DisplayName" "Fumage"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayVersion" "${VERSION}"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayIcon" "$INSTDIR\fumage.exe,0"
    WriteRegStr HKCU "${UNINSTALL}" "Publisher" "The Fumage authors"
    WriteRegStr HKCU "${UNINSTALL}" "InstallLocation" "$INSTDIR"
    WriteRegStr HKCU "${UNINSTALL}" "UninstallString" '"$INSTDIR\uninstall.exe"'
    WriteRegStr HKCU "${UNINSTALL}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
    WriteRegDWORD HKCU "${UNINSTALL}" "NoModify" 1
    WriteRegDWORD HKCU "${UNINSTALL}" "NoRepair" 1
    ${GetSize} "$INSTDIR" "/S=0K" $0 $1 $2
    WriteRegDWORD HKCU "${UNINSTALL}" "EstimatedSize" $0
    ${RefreshShellIcons}
SectionEnd

; Only what was installed: what users have put into the folder stays.
Section Uninstall
    !insertmacro WaitForEnd "fumage.exe"
    !insertmacro WaitForEnd "fumage-cli.exe"
    Delete "$INSTDIR\fumage.exe"
    Delete "$INSTDIR\fumage-cli.exe"
    Delete "$INSTDIR\LICENSE.txt"
    Delete "$INSTDIR\README.txt"
    RMDir /r "$INSTDIR\licences"
    RMDir /r "$INSTDIR\share\fumage"
    RMDir "$INSTDIR\share"
    Delete "$INSTDIR\uninstall.exe"
    RMDir "$INSTDIR"
    ; Those of one that was installed into another folder since are its own.
    ReadRegStr $0 HKCU "${UNINSTALL}" "InstallLocation"
    ${If} $0 != $INSTDIR
        Return
    ${EndIf}
    Delete "$SMPROGRAMS\Fumage.lnk"
    !insertmacro OfferNoMore ".json" "Fumage.Preset"
    !insertmacro OfferNoMore ".png" "Fumage.Picture"
    !insertmacro OfferNoMore ".exr" "Fumage.Picture"
    DeleteRegKey HKCU "${CLASSES}\Fumage.Preset"
    DeleteRegKey HKCU "${CLASSES}\Fumage.Picture"
    DeleteRegKey HKCU "Software\Microsoft\Windows\CurrentVersion\App Paths\fumage.exe"
    DeleteRegKey HKCU "${UNINSTALL}"
    ${RefreshShellIcons}
SectionEnd
