mkgrid --polygon a.xy --model b.obj
