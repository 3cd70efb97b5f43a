; SPDX-License-Identifier: GPL-3.0-or-later
; Installs the program for the current user, without administrator rights. app/package/windows defines VERSION, FILES (the
; folder with the files to install) and OUTPUT.
Target amd64-unicode
SetCompressor /SOLID lzma
SetCompressorDictSize 64 ; MB: the two programs are nearly the same
!include MUI2.nsh

!define CLASSES "Software\Classes"
!define OPENS "Software\Classes\Applications\slidercrank.exe"
!define UNINSTALL "Software\Microsoft\Windows\CurrentVersion\Uninstall\slidercrank"

Name "Slider-Crank"
BrandingText "Slider-Crank ${VERSION}"
OutFile "${OUTPUT}"
RequestExecutionLevel user
InstallDir "$LOCALAPPDATA\Programs\slidercrank"
InstallDirRegKey HKCU "${UNINSTALL}" InstallLocation
VIProductVersion "${VERSION}.0"
VIAddVersionKey ProductName "Slider-Crank"
VIAddVersionKey FileDescription "Slider-Crank Setup"
VIAddVersionKey FileVersion "${VERSION}"
VIAddVersionKey LegalCopyright "2026 the authors of slidercrank, GPL 3 or later"

!define MUI_ICON "${ICON}"
!define MUI_UNICON "${ICON}"
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!define MUI_FINISHPAGE_RUN "$INSTDIR\slidercrank.exe"
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE English
!insertmacro MUI_LANGUAGE Spanish

LangString program ${LANG_ENGLISH} "Slider-Crank"
LangString program ${LANG_SPANISH} "Biela-manivela"
LangString scene ${LANG_ENGLISH} "Slider-crank scene"
LangString scene ${LANG_SPANISH} "Escena de biela-manivela"

; Tells Explorer that the icon of scene files has changed.
!macro announceFileTypes
    System::Call "shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)" ; SHCNE_ASSOCCHANGED
!macroend

Section
    SetOutPath "$INSTDIR"
    File "${FILES}/slidercrank.exe" "${FILES}/slidercrank.com" "${FILES}/LICENSE.txt" "${FILES}/NOTICES.txt"
    WriteUninstaller "$INSTDIR\uninstall.exe"
    CreateShortcut "$SMPROGRAMS\$(program).lnk" "$INSTDIR\slidercrank.exe"

    WriteRegStr HKCU "${CLASSES}\.slidercrank" "" "slidercrank.scene"
    WriteRegStr HKCU "${CLASSES}\slidercrank.scene" "" "$(scene)"
    WriteRegStr HKCU "${CLASSES}\slidercrank.scene\DefaultIcon" "" "$INSTDIR\slidercrank.exe,1"
    WriteRegStr HKCU "${CLASSES}\slidercrank.scene\shell\open\command" "" '"$INSTDIR\slidercrank.exe" "%1"'
    ; Adds the program to the "Open with" list of tables.
    WriteRegStr HKCU "${OPENS}" "FriendlyAppName" "$(program)"
    WriteRegStr HKCU "${OPENS}\shell\open\command" "" '"$INSTDIR\slidercrank.exe" "%1"'
    WriteRegStr HKCU "${OPENS}\SupportedTypes" ".csv" ""
    WriteRegStr HKCU "${OPENS}\SupportedTypes" ".txt" ""
    !insertmacro announceFileTypes

    WriteRegStr HKCU "${UNINSTALL}" DisplayName "$(program)"
    WriteRegStr HKCU "${UNINSTALL}" DisplayVersion "${VERSION}"
    WriteRegStr HKCU "${UNINSTALL}" DisplayIcon "$INSTDIR\slidercrank.exe"
    WriteRegStr HKCU "${UNINSTALL}" InstallLocation "$INSTDIR"
    WriteRegStr HKCU "${UNINSTALL}" UninstallString '"$INSTDIR\uninstall.exe"'
    WriteRegStr HKCU "${UNINSTALL}" QuietUninstallString '"$INSTDIR\uninstall.exe" /S'
    SectionGetSize 0 $0
    WriteRegDWORD HKCU "${UNINSTALL}" EstimatedSize $0
    WriteRegDWORD HKCU "${UNINSTALL}" NoModify 1
    WriteRegDWORD HKCU "${UNINSTALL}" NoRepair 1
SectionEnd

; Removes the installed files, and the folder if it is empty then. The user's settings are kept.
Section Uninstall
    Delete "$INSTDIR\slidercrank.exe"
    Delete "$INSTDIR\slidercrank.com"
    Delete "$INSTDIR\LICENSE.txt"
    Delete "$INSTDIR\NOTICES.txt"
    Delete "$INSTDIR\uninstall.exe"
    RMDir "$INSTDIR"
    Delete "$SMPROGRAMS\Slider-Crank.lnk" ; under both names, because the language may have changed
    Delete "$SMPROGRAMS\Biela-manivela.lnk"
    DeleteRegKey HKCU "${CLASSES}\.slidercrank"
    DeleteRegKey HKCU "${CLASSES}\slidercrank.scene"
    DeleteRegKey HKCU "${OPENS}"
    DeleteRegKey HKCU "${UNINSTALL}"
    !insertmacro announceFileTypes
SectionEnd
