# One line an edit and channel on stderr.
mkgrid --rect 0,0,8,6 --cells 4x3 --depth -1,1 |
    decles-edit --verbose -e 'move v:7 by 0.5 0' -e 'raise both v:12 by 0.25 reach 3' \
        -e begin -e 'move v:6 by 0.5 0' -e 'raise top v:7 by 1' -e end -o out.grid 2>log
sed 's/residual [^ ]*/residual R/' log
